"""The page's navigation, search and menu in a real browser, by mouse and by keyboard alone.
SPRINGCHECK names the program."""

import shutil
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent)]
import browser  # noqa: E402
from program import springcheck  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402

SWEEP = """
fields = true
[[cases]]
scene = ["compression", "torsion"]
method = ["mss-cf", "mss-nfd", "fem-hencky"]
cells = [2, 2, 2]
nu = [0, 0.1, 0.2, 0.3, 0.4, 0.49]
"""
GROUPS = ["Answer", "Tests", "Where methods fail", "Theory", "Data"]
PHONE = (390, 844)


class Navigation(browser.PageTest):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        file = cls.folder / "few.h5"
        (cls.folder / "few.toml").write_text(SWEEP)
        springcheck("sweep", cls.folder / "few.toml", "--out", file)
        springcheck("stability", *"compression --cells 2,2,2 --method mss-cf --over deformation=5%,9% --over nu=0,0.4".split(),
                    "--out", file)
        springcheck("report", file, "--out", cls.folder)
        cls.browser = browser.chromium(webgl=False)
        cls.addClassCleanup(cls.browser.quit)

    def setUp(self):
        self.set_size(1300, 1000)
        self.browser.get("about:blank")
        self.browser.get((self.folder / "index.html").as_uri())
        self.addCleanup(self.check_console)

    def type(self, *keys):
        self.browser.switch_to.active_element.send_keys(*keys)

    def top_of(self, selector):
        return self.script("return document.querySelector(arguments[0]).getBoundingClientRect().top", selector)

    def is_in_sight(self, element):
        place = self.script("const b = arguments[0].getBoundingClientRect(); return [b.top, b.bottom]", element)
        return 0 <= place[0] < self.script("return innerHeight")

    def current(self):
        return [link.text for link in self.every("nav a[aria-current]")]

    def found(self):
        return [link.text for link in self.every("#found a")]

    def test_sections_are_in_groups_and_have_a_link_each(self):
        self.assertEqual([head.get_attribute("textContent") for head in self.every("nav h2")], GROUPS)
        sections = [section.get_attribute("id") for section in self.every("main > section")]
        links = [link.get_dom_attribute("href") for link in self.every("nav a")]
        self.assertEqual(links, [f"#{name}" for name in sections])

    def test_a_link_leads_to_its_section_and_marks_it(self):
        self.assertEqual(self.current(), ["Summary"])
        for name, title in (("torsion", "Torsion"), ("cases", "All cases"), ("compression", "Compression")):
            self.one(f"nav a[href='#{name}']").click()
            self.wait_for(lambda: self.current() == [title], f"{self.current()}, not {title}")
            section = self.one(f"#{name}")
            self.assertTrue(self.is_in_sight(section), name)
            self.assertTrue(self.script("return location.hash") == f"#{name}")

    def test_an_address_leads_to_its_section(self):
        self.browser.get("about:blank")
        self.browser.get((self.folder / "index.html").as_uri() + "#provenance")
        time.sleep(1.2)
        self.assertTrue(self.is_in_sight(self.one("#provenance h2")))
        self.one("nav a[href='#torsion']").click()
        time.sleep(1.2)
        self.assertLess(abs(self.top_of("#torsion")), 40)

    def test_the_navigation_stays_in_sight(self):
        self.script("scrollTo(0, document.documentElement.scrollHeight)")
        self.wait_for(lambda: self.current() == [self.every("nav a")[-1].text], "the last section is current")
        self.assertTrue(self.is_in_sight(self.one("nav a[aria-current]")))
        self.assertTrue(self.is_in_sight(self.one("#search")))

    def test_search_finds_sections_tables_figures_and_cases(self):
        field = self.one("#search")
        for words, head, text in (
            ("torsion", "Sections", "Torsion"),
            ("small deformation", "Tables", "Small deformation, ½ to 5 %"),
            ("bodies torsion", "Figures", "Deformed bodies"),
            ("compression mss-nfd 0.49", "Cases", "mss-nfd, compression"),
        ):
            field.clear()
            field.send_keys(words)
            heads = [line.text.split(",")[0] for line in self.every("#found .head")]
            self.assertIn(head, heads, words)
            self.assertTrue(any(text in line for line in self.found()), (words, self.found()))

    def test_cases_that_are_found_are_those_with_all_words(self):
        self.one("#search").send_keys("torsion mss-nfd 0.3")
        self.assertEqual(len([line for line in self.found() if line.startswith("mss-nfd, torsion")]), 1)
        self.assertIn("1 case", self.one("#found p").text)

    def test_nothing_found_is_said(self):
        self.one("#search").send_keys("compresion")
        self.assertEqual(self.one("#found p").text, "Nothing on this page has all of these words.")
        self.assertEqual(self.found(), [])

    def test_a_case_that_is_found_is_shown(self):
        self.one("#search").send_keys("torsion mss-nfd 0.3", Keys.ENTER)
        self.wait_for(lambda: self.one("#case").is_displayed(), "the case is shown")
        self.assertIn("springcheck run torsion --method mss-nfd", self.one("#case").text)
        self.assertIn("--nu 0.3", self.one("#case").text)
        self.type(Keys.ESCAPE)
        self.assertFalse(self.one("#case").is_displayed())
        self.assertEqual(self.script("return document.activeElement.id"), "search")  # among what was found

    def test_what_is_folded_opens(self):
        self.script("const fold = document.createElement('details'), table = document.getElementById('table-answers-torsion');"
                    "table.parentElement.before(fold); fold.append(table.parentElement)")
        self.assertIsNone(self.one("main details:has(#table-answers-torsion)").get_attribute("open"))
        self.one("#search").send_keys("answers-torsion", Keys.ENTER)
        self.wait_for(lambda: self.is_in_sight(self.one("#table-answers-torsion.sought")), "the table is in sight")
        self.assertTrue(self.one("main details:has(#table-answers-torsion)").get_attribute("open"))

    def test_keyboard_alone(self):
        self.type(Keys.TAB)
        self.assertEqual(self.script("return document.activeElement.className"), "skip")
        self.assertGreaterEqual(self.script("return document.activeElement.getBoundingClientRect().left"), 0)
        self.type(Keys.ENTER)
        self.assertEqual(self.script("return document.activeElement.id"), "content")
        self.type("/")
        self.assertEqual(self.script("return document.activeElement.id"), "search")
        self.type("torsion")
        lines = self.found()
        self.type(Keys.ARROW_DOWN)
        self.type(Keys.ARROW_DOWN)
        self.assertEqual(self.script("return document.activeElement.textContent").split(), lines[1].split())
        self.type(Keys.ARROW_UP)
        self.type(Keys.ENTER)
        self.wait_for(lambda: self.is_in_sight(self.one("#torsion")), "the section is in sight")
        self.assertEqual(self.script("return document.activeElement.id"), "torsion")
        self.type("/")
        self.type(Keys.ESCAPE)
        self.assertFalse(self.one("#found").is_displayed())

    def test_on_a_phone_nothing_is_wider_than_the_screen(self):
        self.set_size(*PHONE)
        self.script("for (const s of document.querySelectorAll('main > section')) s.style.contentVisibility = 'visible';"
                    "for (const d of document.querySelectorAll('details')) d.open = true")
        self.assertLessEqual(self.script("return document.documentElement.scrollWidth"), PHONE[0])

    def test_on_a_phone_a_menu_opens_and_closes(self):
        self.set_size(*PHONE)
        navigation, menu = self.one("#navigation"), self.one("#menu")
        self.assertFalse(navigation.is_displayed())
        menu.click()
        self.assertTrue(navigation.is_displayed())
        self.assertEqual(menu.get_attribute("aria-expanded"), "true")
        self.type(Keys.ESCAPE)
        self.assertFalse(navigation.is_displayed())
        self.assertEqual(self.script("return document.activeElement.id"), "menu")
        menu.click()
        self.one("nav a[href='#torsion']").click()
        self.assertFalse(navigation.is_displayed())
        self.wait_for(lambda: self.is_in_sight(self.one("#torsion h2")), "the section is in sight")
        self.assertGreater(self.top_of("#torsion h2"), self.one("header").size["height"] - 1)
        menu.click()
        self.one("#search").send_keys("mss-nfd 0.3 torsion", Keys.ENTER)
        self.wait_for(lambda: self.one("#case").is_displayed(), "the case is shown")
        self.assertFalse(navigation.is_displayed())

    def test_without_scripts_the_navigation_is_there(self):
        self.browser.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": True})
        try:
            self.browser.refresh()
            self.set_size(*PHONE)
            self.assertTrue(self.one("nav a[href='#torsion']").is_displayed())
            self.assertFalse(self.one("#menu").is_displayed())
        finally:
            self.browser.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": False})


if __name__ == "__main__":
    unittest.main()
