"""A report of many cases, made once, and what tests of its page do with it."""

import io
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parents[2] / "reports")]
import browser  # noqa: E402
import numpy as np  # noqa: E402
import springcheck_results  # noqa: E402
from matplotlib.image import imread  # noqa: E402
from program import springcheck  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402

DOLLARS = r"$\undefined{$"  # matplotlib would take it for a formula
LABEL = "mine <img src=x onerror=alert(1)> & Ω"
SWEEP = """
fields = true
[[cases]]
scene = ["compression", "shearing", "torsion"]
method = ["mss-cf", "mss-nfd", "fem-hencky"]
cells = [4, 4, 4]
nu = [0, 0.1, 0.25, 0.4, 0.499]
[[cases]]
scene = "torsion"
method = ["mss-cf", "fem-hencky"]
cells = [4, 4, 4]
nu = 0.25
reference = "fem-hencky"
[[cases]]
scene = "compression"
method = ["mss-cf", "mss-nfd", "fem-stvk"]
cells = [4, 4, 4]
deformation = ["1%", "2%", "10%", "20%"]
[[cases]]
scene = "compression"
method = ["mss-affine", "mss-cf", "fem-hencky"]
cells = [3, 3, 3]
cell-type = "mixed"
[[cases]]
scene = "tension"
method = ["mss-cf", "fem-hencky"]
cells = [2, 2, 12]
[[cases]]
scene = "bending"
method = ["mss-cf", "fem-stvk"]
cells = [2, 2, 12]
[[cases]]
scene = "bending"
method = "mss-cf"
cells = [2, 2, 12]
diagonal-ratio = [0.1, 10]
"""


def measured_csv(folder):
    """A displacement field of the 4 x 4 x 4 cube in compression by 5 %, as users write it."""
    ticks = np.linspace(0, 0.05, 5)
    rows = [f"{x},{y},{z},0,0,{-0.05 * z}" for z in ticks for y in ticks for x in ticks]
    path = folder / "mine.csv"
    path.write_text("x,y,z,ux,uy,uz\n" + "\n".join(rows) + "\n")
    return path


class ReportPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.file = cls.folder / "Ω <results> & more.h5"
        (cls.folder / "sweep.toml").write_text(SWEEP)
        springcheck("sweep", cls.folder / "sweep.toml", "--out", cls.file)
        for scene in (  # rows of the thesis's tables
            "compression --deformation 5%", "tension --deformation 5%", "shearing --deformation 20%",
            "torsion --deformation 45deg", "bending --young 10e6",
        ):
            springcheck("run", *scene.split(), "--method", "mss-cf,fem-hencky", "--nu", "0.25", "--out",
                        cls.file)
        springcheck("measure", "compression", "--cells", "4,4,4", "--displacements",
                    measured_csv(cls.folder), "--label", LABEL, "--out", cls.file)
        springcheck("measure", "compression", "--cells", "4,4,4", "--nu", "0.25", "--displacements",
                    measured_csv(cls.folder), "--label", DOLLARS, "--out", cls.file)
        for further in (  # a motion, a map of failure and a chart
            "run torsion --cells 2,2,2 --method mss-cf --solver verlet --damping 0.3 --duration 0.2 --history 10",
            "stability torsion --cells 2,2,2 --method mss-cf --over deformation=5deg,9deg --over nu=0,0.3",
            "chart torsion --converged-across 1 --sizes 2 --budget 0.001 --least-models 0 --on-threads 1",
        ):
            springcheck(*further.split(), "--out", cls.file)
        cls.report = cls.folder / "report"
        springcheck("report", cls.file, "--out", cls.report)
        cls.results = springcheck_results.read(cls.file)
        cls.browser = cls.opened(webgl=True)
        cls.without_webgl = cls.opened(webgl=False)  # quicker, where no view is looked at

    @classmethod
    def opened(cls, webgl):
        driver = browser.chromium(webgl)
        cls.addClassCleanup(driver.quit)
        driver.get((cls.report / "index.html").as_uri())
        return driver

    def every(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def pdf_differs(self, name, shown):
        """Mean difference of the PDF's pixels from those of the page, 16 x 16 at once."""
        pdf = self.report / "figures" / f"{name}.pdf"
        height, width = shown.shape[:2]
        made = subprocess.run(
            ["pdftoppm", "-png", "-r", "72", "-scale-to-x", str(width), "-scale-to-y", str(height), pdf],
            check=True, capture_output=True)
        printed = imread(io.BytesIO(made.stdout), format="png")[:, :, :3]

        def coarse(image):
            rows, columns = height // 16, width // 16
            blocks = image[: 16 * rows, : 16 * columns].reshape(rows, 16, columns, 16, 3)
            return blocks.mean(axis=(1, 3))

        return float(np.abs(coarse(printed) - coarse(shown)).max(axis=2).mean())

    def view(self, test):
        """The drawn view of a test: (its element, its plot)."""
        element = self.browser.find_element(By.CSS_SELECTOR, f".viewer[data-test={test}]")
        browser.show(self.browser, element)
        plot = element.find_element(By.CLASS_NAME, "plot")
        for _ in range(300):
            if plot.get_attribute("data-drawn"):
                break
            time.sleep(0.1)
        self.assertEqual(plot.get_attribute("data-drawn"), "yes")
        time.sleep(0.5)
        return element, plot

    def cameras(self, plot):
        script = "return ['scene', 'scene2', 'scene3'].map((name) => arguments[0].layout[name].camera)"
        return self.browser.execute_script(script, plot)
