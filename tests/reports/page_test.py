"""The page of a report in a real browser. SPRINGCHECK names the program."""

import base64
import gzip
import re
import sys
import time
import unittest
from itertools import pairwise
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent)]
import browser  # noqa: E402
import numpy as np  # noqa: E402
from report_page import DOLLARS, LABEL, ReportPage  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402

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


class Page(ReportPage):
    TURNED = ("compression",)

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
        self.assertLessEqual({"through-time", "chart", "atlas", "provenance"}, set(names))
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
        driver.execute_script("document.querySelectorAll('details').forEach((part) => (part.open = true))")
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
        cases = self.results.cases
        asked = (cases.test == "torsion") & cases.method.str.contains("nfd")
        self.assertEqual(len(kept), asked.sum())
        self.assertLess(len(kept), len(before))
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


if __name__ == "__main__":
    unittest.main()
