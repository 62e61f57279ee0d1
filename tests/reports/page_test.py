"""The page of a report in a real browser. SPRINGCHECK names the program."""

import base64
import contextlib
import gzip
import io
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from itertools import pairwise
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).parents[2] / "reports")]
import browser  # noqa: E402
import numpy as np  # noqa: E402
import page_text  # noqa: E402
import springcheck_results  # noqa: E402
from matplotlib.image import imread  # noqa: E402
from program import springcheck  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402

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
# Of the quantity that a table of the thesis prints: measure, and its factor to the table's unit.
PRINTED = {
    "5.1": ("volume_error", 100),
    "5.2": ("volume_error", 100),
    "5.3": ("plate_force_norm", 1e4),
    "5.4": ("plate_torque", 1e6),
    "deviation": ("middle_layer_deviation", 100),
    "bending": ("tip_deflection", 1),
}
# The same of columns of the table of all cases, by their heads.
COLUMNS = {
    "nu": ("nu", 1),
    "E [Pa]": ("young", 1),
    "deformation [-, rad]": ("deformation", 1),
    "volume change, absolute [%]": ("volume_error", 100),
    "resultant force [N]": ("plate_force_norm", 1),
    "torque [N m]": ("plate_torque", 1),
    "tip deflection [m]": ("tip_deflection", 1),
    "least V/V0": ("cell_volume_ratio_min", 1),
    "deviation L2 [%]": ("deviation_l2_relative", 100),
    "solution time [s]": ("solve_wall_s", 1),
}


def measured_csv(folder):
    """A displacement field of the 4 x 4 x 4 cube in compression by 5 %, as users write it."""
    ticks = np.linspace(0, 0.05, 5)
    rows = [f"{x},{y},{z},0,0,{-0.05 * z}" for z in ticks for y in ticks for x in ticks]
    path = folder / "mine.csv"
    path.write_text("x,y,z,ux,uy,uz\n" + "\n".join(rows) + "\n")
    return path


class Page(unittest.TestCase):
    TURNED = ("compression",)

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

    def test_the_page_is_whole_and_asks_for_nothing(self):
        self.assertLess((self.report / "index.html").stat().st_size, 15e6)
        loaded = self.browser.execute_script(
            "return performance.getEntriesByType('resource').map((entry) => entry.name)"
            ".filter((name) => !/^(data|blob):/.test(name))"
        )
        self.assertEqual(loaded, [])

    def test_sections_are_those_with_data(self):
        names = [section.get_attribute("id") for section in self.every("main > section")]
        tests = ["compression", "tension", "shearing", "torsion", "bending"]
        self.assertEqual(names[:8], ["summary", "explore", "thesis-tables", *tests])
        self.assertIn("provenance", names)
        self.assertNotIn("empty", names)
        self.assertNotIn("error-parts", names)  # there is no table split

    def test_links_lead_somewhere(self):
        links = {link.get_dom_attribute("href") for link in self.every("a[href]")}
        self.assertGreater(len(links), 20)
        for link in links:
            if link.startswith("#case="):
                self.assertIn(link.removeprefix("#case="), self.results.cases.index)
            elif link.startswith("#"):
                link = link.partition("?")[0]  # of the explorer, see explorer_test.py
                found = self.browser.execute_script("return document.getElementById(arguments[0])", link[1:])
                self.assertIsNotNone(found, link)
            else:
                self.assertTrue((self.report / link).is_file(), link)

    def test_every_figure_is_drawn_in_all_forms(self):
        driver = self.without_webgl
        figures = driver.find_elements(By.CSS_SELECTOR, "main figure")
        self.assertGreater(len(figures), 10)
        for figure in figures:
            image = figure.find_element(By.TAG_NAME, "img")
            browser.show(driver, image)  # it is drawn when it comes into sight
            name = figure.get_attribute("id").removeprefix("figure-")
            self.assertGreater(driver.execute_script("return arguments[0].naturalWidth", image), 100)
            self.assertGreater(browser.drawn_share(browser.pixels(image)), 0.01, name)
            self.assertTrue(image.get_attribute("alt"))
            self.assertLess(self.pdf_differs(name, browser.pixels(image)), 0.03, name)

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

    def test_bodies_turn_together(self):
        for test in self.TURNED:
            _, plot = self.view(test)
            before = browser.pixels(plot)
            self.assertGreater(browser.drawn_share(before), 0.1)
            self.browser.execute_script(
                "Plotly.relayout(arguments[0],"
                " {'scene2.camera': {eye: {x: -2, y: 0.4, z: 0.3}, up: {x: 0, y: 0, z: 1}}})",
                plot,
            )
            time.sleep(1)
            first, second, third = self.cameras(plot)
            self.assertEqual(first["eye"], {"x": -2, "y": 0.4, "z": 0.3})
            self.assertEqual(first, second)
            self.assertEqual(first, third)
            after = browser.pixels(plot)
            self.assertGreater(np.abs(after - before).max(axis=2).mean(), 0.02)
            self.assertGreater(browser.drawn_share(after), 0.1)

    def test_views_follow_their_choices(self):
        element, plot = self.view("torsion")
        quantity = element.find_elements(By.TAG_NAME, "select")[3]
        shown = []
        for value in ("displacement", "volume", "strain", "deviation"):
            self.browser.execute_script(
                "arguments[0].value = arguments[1];"
                " arguments[0].dispatchEvent(new Event('change'))", quantity, value)
            time.sleep(1)
            shown.append(browser.pixels(plot))
        for before, after in pairwise(shown):
            self.assertGreater(np.abs(before - after).max(axis=2).mean(), 0.02)
        self.assertRegex(element.text, r"mss-\w+ over fem-\S+ \(dark\)")

    def test_a_case_leads_to_its_body(self):
        """To the view of its test, with the case chosen."""
        cases = self.results.cases
        key = cases.index[(cases.test == "torsion") & (cases.method == "mss-nfd") & (cases.nu == 0.4)][0]
        self.browser.execute_script("location.hash = `#case=${arguments[0]}`", key)
        time.sleep(0.5)
        self.browser.find_element(By.CSS_SELECTOR, "#case .body").click()
        element, plot = self.view("torsion")
        group, springs, _, _ = element.find_elements(By.TAG_NAME, "select")
        chosen = [self.browser.execute_script("return arguments[0].selectedOptions[0].text", one) for one in (group, springs)]
        self.assertIn("nu 0.4", chosen[0])
        self.assertTrue(chosen[1].startswith("mss-nfd"))
        self.assertFalse(self.browser.find_element(By.ID, "case").is_displayed())

    def test_numbers_are_those_of_the_file(self):
        cases = self.results.cases
        numbers = self.browser.execute_script(
            "return [...document.querySelectorAll('data[data-case]')].map((element) =>"
            " ({...element.dataset, value: element.value, text: element.textContent}))"
        )
        measured = [number for number in numbers if "measure" in number]
        printed = [number for number in numbers if number.get("table") in PRINTED]
        self.assertGreater(len(measured), 15)
        self.assertEqual({number["table"] for number in printed}, set(PRINTED))
        for number in measured + printed:
            if "measure" in number:
                measure, factor = number["measure"], 1
            else:
                measure, factor = PRINTED[number["table"]]
            stored = cases.loc[number["case"], measure] * factor
            shown = float(number["value"])
            self.assertAlmostEqual(shown, stored, delta=1e-12 * abs(stored))
            text = number["text"].split()[0].replace("−", "-")
            decimals = len(text.partition("e")[0].partition(".")[2])
            exponent = int(text.partition("e")[2] or 0)
            # Whole numbers are rounded to four digits.
            step = 10.0 ** (exponent - decimals) if decimals else max(1, 10 ** (len(text) - 4))
            self.assertLessEqual(abs(float(text) - shown), 0.5001 * step, number)

    def test_the_table_of_all_cases_is_the_file(self):
        table = self.browser.find_element(By.ID, "table-cases")
        rows = self.browser.execute_script(
            "const heads = [...arguments[0].tHead.rows[0].cells].map((cell) => cell.textContent);"
            "return [...arguments[0].tBodies[0].rows].map((row) => Object.fromEntries([...row.cells]"
            ".map((cell, i) => [heads[i], cell.querySelector('data')?.value ?? cell.textContent])))",
            table,
        )
        cases = self.results.cases
        self.assertEqual(len(rows), len(cases))
        for row in rows:
            case = cases.loc[cases.index[cases.index.str.startswith(row["case"])][0]]
            self.assertEqual(row["status"].replace(" ", "_"), case.status)
            for head, (measure, factor) in COLUMNS.items():
                if row.get(head) in (None, "", row["status"]):
                    continue
                self.assertAlmostEqual(float(row[head]), factor * case[measure],
                                       delta=1e-12 * abs(factor * case[measure]))

    def test_medians_of_the_summary(self):
        """Of mss-cf in compression and shearing, by hand from the file."""
        cases = self.results.cases
        for test, answer in (("compression", "plate_force"), ("shearing", "plate_force_norm")):
            small = cases[(cases.test == test) & cases.deformation.between(0.005, 0.051)]
            small = small[small["cell-type"] == "hexahedron"]
            differences, usable = [], 0
            springs = cases[(cases.test == test) & cases.deformation.between(0.005, 0.051)]
            springs = springs[springs.method == "mss-cf"]
            for _, case in springs[springs.status == "ok"].iterrows():
                usable += 1
                same = small[(small["mesh"] == case["mesh"]) & (small.nu == case.nu)]
                same = same[(same.deformation == case.deformation) & (same.element == "q1-sri")]
                for law in ("fem-hencky", "fem-stvk"):
                    found = same[same.method == law]
                    if len(found):
                        theirs = found.iloc[0][answer]
                        differences.append(abs(case[answer] - theirs) / abs(theirs))
                        break
            covered = (springs.status != "refused").sum()
            self.assertGreater(len(differences), 4)
            median = 100 * np.median(differences)
            row = self.browser.execute_script(
                "const heads = [...document.querySelectorAll('#table-summary-small th')]"
                ".map((cell) => cell.textContent);"
                "return [...document.querySelectorAll('#table-summary-small tbody tr')]"
                ".find((row) => row.querySelector('b').textContent === 'mss-cf')"
                ".cells[heads.indexOf(arguments[0])].textContent", test)
            shown, largest, count = re.fullmatch(r"(\S+) % up to (\S+) % (\d+ of \d+)", row).groups()
            self.assertEqual(count, f"{usable} of {covered}")
            for text, value in ((shown, median), (largest, 100 * max(differences))):
                self.assertAlmostEqual(float(text), value, delta=0.051 * value)  # two digits

    def test_names_are_text_in_the_explorer(self):
        """In its legend and where a mark is read."""
        driver = self.without_webgl
        driver.execute_script("location.hash = '#explore?test=compression&x=nu&y=plate_force,volume_change&fixed=none'")
        for _ in range(100):
            names = [one.get_attribute("textContent") for one in driver.find_elements(By.CSS_SELECTOR, ".explorer .legendtext")]
            if LABEL in names:
                break
            time.sleep(0.1)
        self.assertIn(LABEL, names)
        self.assertIn(DOLLARS, names)
        self.assertEqual(driver.find_elements(By.CSS_SELECTOR, ".explorer img"), [])

    def test_names_are_text(self):
        self.assertIn(LABEL, self.browser.find_element(By.ID, "summary").text)
        self.assertEqual(self.every("img[src=x]"), [])
        self.assertIn("Ω <results> & more.h5", self.browser.title)

    def test_heads_sort_columns(self):
        table = self.browser.find_element(By.ID, "table-cases")
        heads = [head.get_attribute("textContent") for head in table.find_elements(By.TAG_NAME, "th")]
        head = table.find_elements(By.TAG_NAME, "th")[heads.index("nu")]
        button = head.find_element(By.TAG_NAME, "button")
        self.browser.execute_script("arguments[0].focus()", button)
        button.send_keys(Keys.ENTER)
        self.assertEqual(head.get_attribute("aria-sort"), "ascending")
        nus = self.browser.execute_script(
            "return [...arguments[0].tBodies[0].rows].map((row) => Number(row.cells[arguments[1]].textContent))",
            table, heads.index("nu"),
        )
        self.assertEqual(nus, sorted(nus))
        button.send_keys(Keys.ENTER)
        self.assertEqual(head.get_attribute("aria-sort"), "descending")

    def test_long_tables_have_a_filter(self):
        shown = (
            "return [...document.querySelectorAll('#table-cases tbody tr')]"
            ".filter((row) => !row.hidden).map((row) => row.textContent)"
        )
        field = self.browser.find_element(By.CSS_SELECTOR, "#cases input")
        before = self.browser.execute_script(shown)
        field.send_keys("torsion nfd")
        kept = self.browser.execute_script(shown)
        self.assertEqual(kept, [row for row in before if "torsion" in row and "nfd" in row])
        self.assertEqual(len(kept), 5)
        field.clear()

    def test_print_has_pictures_in_the_views_places(self):
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
        try:
            shown = [view.is_displayed() for view in self.every(".viewer")]
            self.assertEqual(set(shown), {False})
            self.assertTrue(self.browser.find_element(By.ID, "figure-bodies_compression").is_displayed())
        finally:
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})

    def test_without_webgl_pictures_stand_for_views(self):
        driver = self.without_webgl
        views = driver.find_elements(By.CSS_SELECTOR, ".viewer")
        self.assertEqual({view.is_displayed() for view in views}, {False})
        picture = driver.find_element(By.CSS_SELECTOR, "#figure-bodies_compression img")
        browser.show(driver, picture)
        self.assertGreater(browser.drawn_share(browser.pixels(picture)), 0.05)

    def test_zz_the_console_is_free_of_errors(self):
        """Last: of everything that the other tests did."""
        for driver in (self.browser, self.without_webgl):
            errors = [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"]
            self.assertEqual(errors, [])

    def test_scripts_of_others_come_with_their_licences(self):
        page = (self.report / "index.html").read_text(encoding="utf-8")
        packed = re.search(r'id="plotly">([^<]*)<', page)[1]
        self.assertIn("* plotly.js v", gzip.decompress(base64.b64decode(packed)).decode()[:300])
        for licence in ("MIT License: Permission", "ISC License: Permission", "BSD-3-Clause License: R"):
            self.assertEqual(page.count(licence), 1)

    def test_files_for_paraview(self):
        import meshio

        names = sorted(path.name for path in (self.report / "3d").glob("*.vtu"))
        with_fields = self.results.field_names()
        self.assertEqual(len(names), len(with_fields))
        cases = self.results.cases
        key = cases.index[(cases.method == "mss-affine") & (cases["cell-type"] == "mixed")][0]
        (path,) = (self.report / "3d").glob(f"*{key[:8]}.vtu")
        read, mesh, fields = meshio.read(path), self.results.mesh(key), self.results.fields(key)
        np.testing.assert_array_equal(read.points, mesh["nodes"])
        np.testing.assert_array_equal(read.point_data["displacement [m]"], fields["displacement"])
        np.testing.assert_array_equal(read.point_data["deviation [m]"], fields["deviation"])
        np.testing.assert_array_equal(read.point_data["reaction [N]"], fields["reaction"])
        self.assertLess(max(len(name) for name in names), 80)
        for name in ("cell_volume_ratio", "spring_strain"):
            np.testing.assert_array_equal(np.concatenate(read.cell_data[name]), fields[name])
        strains = fields["spring_strain"]
        self.assertLess(strains.min(), -0.04)  # pressed by 5 %


class SmallFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """A file of one case, and its report."""
        one = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, one)
        cls.one, cls.report_of_one = one / "one.h5", one / "report"
        springcheck("run", "compression", "--method", "mss-cf", "--cells", "2,2,2", "--nu", "0.25",
                    "--out", cls.one)
        springcheck("report", cls.one, "--out", cls.report_of_one)

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def page_of(self, file):
        mine = self.folder / "report" / "figures" / "mine.svg"
        mine.parent.mkdir(parents=True, exist_ok=True)
        mine.write_text("mine")
        said = springcheck("report", file, "--out", self.folder / "report").stderr
        self.assertNotIn("Warning", said)  # of Python to its programmers, not to users
        self.assertEqual(mine.read_text(), "mine")  # files of others stay
        return (self.folder / "report" / "index.html").read_text(encoding="utf-8")

    def test_an_empty_file_says_what_to_run(self):
        import h5py

        file = self.folder / "empty.h5"
        with h5py.File(file, "w") as made:
            made.attrs["layout"] = 2
            for name in ("cases", "provenance", "meshes", "fields"):
                made.create_group(name)
        page = self.page_of(file)
        self.assertIn("springcheck run compression --out", page)
        self.assertNotIn("Plotly", page)

    def test_one_case(self):
        page = (self.report_of_one / "index.html").read_text(encoding="utf-8")
        self.assertIn("1 case: 1 ok", page)
        for name in ("chart", "atlas", "tissue", "through-time", "speed", "modes"):
            self.assertIsNone(page_text.section(page, name), name)

    def test_failed_and_refused_cases_alone(self):
        file = self.folder / "failed.h5"
        springcheck("run", "compression", "--method", "mss-nfd,mss-lloyd", "--cells", "4,4,4", "--nu",
                    "0", "--deformation", "20%", "--out", file, check=False)
        page = self.page_of(file)
        self.assertIn("no equilibrium", page)
        self.assertIn("refused (its springs need tetrahedra", page)
        self.assertIn('id="failures"', page)

    def test_a_mesh_of_a_file_and_other_tests(self):
        file = self.folder / "kidney.h5"
        springcheck("run", "kidney", "--cells", "4,4,4", "--out", file)
        springcheck("run", "traction", "--cells", "2,2,2", "--method", "mss-cf", "--out", file)
        page = self.page_of(file)
        self.assertIn('data-test="compression"', page)
        self.assertIn('data-test="traction"', page)

    def test_what_an_earlier_report_made_goes_and_what_others_made_stays(self):
        shutil.copytree(self.report_of_one, self.folder / "report")
        made = set((self.folder / "report" / "3d").iterdir())
        springcheck("run", "shearing", "--method", "mss-cf", "--cells", "2,2,2", "--out",
                    self.folder / "two.h5")
        self.page_of(self.folder / "two.h5")
        left = made & set((self.folder / "report" / "3d").iterdir())
        self.assertEqual({path.name for path in left}, {"show.py", "cases.xdmf"})
        (self.folder / "report" / "index.html").write_text("<p>my page</p>")
        ended = springcheck("report", self.one, "--out", self.folder / "report", check=False)
        self.assertEqual(ended.returncode, 2)
        self.assertEqual((self.folder / "report" / "index.html").read_text(), "<p>my page</p>")

    def test_broken_fields_are_left_out(self):
        import h5py

        file = self.folder / "broken.h5"
        springcheck("run", "compression", "--method", "mss-cf,mss-fd,fem-hencky", "--cells", "2,2,2",
                    "--nu", "0.25", "--out", file)
        with h5py.File(file, "r+") as made:
            first, second, _ = made["fields"]
            made["fields"][first]["displacement"][0, 0] = np.nan
            del made["fields"][second]["cell_volume_ratio"]
            made["cases"]["cell_volume_ratio_min"][...] = np.nan
        self.assertIn('id="figure-bodies_compression"', self.page_of(file))

    def test_a_page_stays_whole_when_the_next_is_ended(self):
        report = self.folder / "report"
        shutil.copytree(self.report_of_one, report)
        page = (report / "index.html").read_text(encoding="utf-8")
        before = sorted(report.rglob("*"))
        unfinished = report / "data" / "unfinished"
        for end in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            unfinished.mkdir()  # left by one that could not clean up
            (unfinished / "old").touch()
            started = subprocess.Popen(
                [os.environ["SPRINGCHECK"], "report", self.one, "--out", report],
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            while started.poll() is None and not (unfinished / "figures").exists():
                time.sleep(0.01)
            started.send_signal(end)
            _, errors = started.communicate()
            if started.returncode != 0:  # else it was done already
                self.assertEqual(started.returncode, -end)
                self.assertNotIn("Traceback", errors)
                self.assertEqual(sorted(report.rglob("*")), before)
            self.assertEqual((report / "index.html").read_text(encoding="utf-8"), page)

    def test_missing_packages_are_named(self):
        import runpy

        main = runpy.run_path(str(Path(__file__).parents[2] / "reports/springcheck_report/__main__.py"))
        main["PACKAGES"]["no_such_module"] = "python3-no-such"
        self.assertEqual(main["missing_packages"](), ["python3-no-such"])
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors):
            self.assertEqual(main["main"](["a.h5", "b"]), 1)
        self.assertIn("sudo apt-get install python3-no-such", errors.getvalue())

    def test_bad_input_is_named_and_nothing_is_written(self):
        text = self.folder / "notes.h5"
        text.write_text("notes")
        for file in (text, self.folder / "none.h5"):
            ended = springcheck("report", file, "--out", self.folder / "out", check=False)
            self.assertEqual(ended.returncode, 2)
            self.assertIn(str(file), ended.stderr)
            self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
