"""Chromium without a window, for tests of the page, and what they do with it."""

import base64
import io
import time
import unittest

import numpy as np
from matplotlib.image import imread
from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By


def chromium(webgl=True):
    options = Options()
    flags = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--window-size=1300,1700"]
    flags += ["--hide-scrollbars", "--force-device-scale-factor=1"]
    if webgl:
        flags += ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    else:
        flags += ["--disable-gpu", "--disable-3d-apis"]
    for flag in flags:
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    driver.set_page_load_timeout(60)
    return driver


class PageTest(unittest.TestCase):
    """Tests that drive cls.browser, each of which must leave the console empty."""

    def check_console(self):
        # Of WebGL without a graphics card Chromium warns by itself.
        said = [entry for entry in self.browser.get_log("browser") if entry["source"] != "rendering"]
        self.assertEqual(said, [])

    def set_size(self, width, height):
        metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)

    def every(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def one(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def wait_for(self, check, what):
        for _ in range(80):
            if check():
                return
            time.sleep(0.1)
        self.fail(what)


def show(driver, element):
    """Scrolls to the element; twice, as sections get their size when they come into sight."""
    for _ in range(2):
        driver.execute_script("arguments[0].scrollIntoView({behavior: 'instant'})", element)
        time.sleep(0.2)


def pixels(element):
    """The element's screenshot: rows x columns x 3 in [0, 1]."""
    content = base64.b64decode(element.screenshot_as_base64)
    return imread(io.BytesIO(content), format="png")[:, :, :3]


def drawn_share(image):
    """Share of pixels that are not the page's white."""
    return float((np.abs(image - 1).max(axis=2) > 0.02).mean())
