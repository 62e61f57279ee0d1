"""The page's explorer and its view of a case in a real browser, against the result file.
SPRINGCHECK names the program."""

import csv
import io
import re
import shlex
import sys
import time
import unittest
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).parents[2] / "reports")]
import springcheck_results  # noqa: E402
from explorer_page import PLOTTED, RUNS, ExplorerPage  # noqa: E402
from program import same_figures, springcheck  # noqa: E402
from selenium.webdriver.common.action_chains import ActionChains  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402


class Explorer(ExplorerPage):
    def test_it_begins_with_compression_over_nu_and_the_distance_from_elements(self):
        self.open("#explore")
        fields = self.script("return ['test', 'x'].map((name) => document.querySelector('.explorer form').elements[name].value)")
        self.assertEqual(fields, ["compression", "nu"])
        boxes = self.browser.find_elements(By.CSS_SELECTOR, ".explorer input[name=y]:checked")
        self.assertEqual({box.get_attribute("value") for box in boxes}, {"plate_force", "answer_difference"})

    def test_the_marks_are_the_files_cases(self):
        self.open("#explore?test=compression&x=nu&y=plate_force,volume_change")
        seen = {"plate_force": set(), "volume_change": set()}
        for trace in self.script(PLOTTED):
            measure = "plate_force" if trace["axis"] == "y" else "volume_change"
            for x, y, place in zip(trace["x"], trace["y"], trace["places"]):
                case = self.cases.loc[self.key(place)]
                self.assertEqual((case.nu, case.test, case["cells.x"]), (x, "compression", 2))
                shown = {"plate_force": 1, "volume_change": 100}[measure] * case[measure]
                self.assertAlmostEqual(shown, y, delta=1e-14 * abs(shown))
                self.assertNotIn((case.method, case.nu), seen[measure])  # one beside another reference is left out
                seen[measure].add((case.method, case.nu))
        self.assertEqual(seen, dict.fromkeys(seen, self.usual_over_nu()))
        self.assertIn("1 more are the same simulations beside another reference", self.one(".explorer .said").text)

    def test_differences_from_elements_are_in_percent(self):
        self.open("#explore?test=compression&x=nu&y=answer_difference,volume_difference&methods=mss-cf")
        titles = self.script("const layout = document.querySelector('.explorer .plot').layout;"
                             "return [layout.yaxis.title.text, layout.yaxis2.title.text]")
        self.assertRegex(titles[0], r"\[%\]")
        self.assertRegex(titles[1], r"\[% of V0\]")
        judged = {"y": 0, "y2": 0}
        for trace in self.script(PLOTTED):
            for y, place in zip(trace["y"], trace["places"]):
                case = self.cases.loc[self.key(place)]
                if (judge := self.script("return allCases.value('judge', arguments[0])", place)) is None:
                    continue
                columns = ("scene", "nu", "deformation", "cells.x")
                same = (self.cases[list(columns)] == case[list(columns)]).all(axis=1)
                theirs = self.cases[same & (self.cases.method == judge.split(":")[0])].iloc[0]
                if trace["axis"] == "y":
                    self.assertAlmostEqual(y, 100 * (case.plate_force / theirs.plate_force - 1), delta=1e-9)
                else:
                    self.assertAlmostEqual(y, 100 * (case.volume_change - theirs.volume_change), delta=1e-9)
                judged[trace["axis"]] += 1
        self.assertGreater(min(judged.values()), 2)

    def test_references_are_told_apart_where_they_matter(self):
        self.open("#explore?test=compression&x=nu&y=deviation_l2_relative&m=mss-cf")
        (trace,) = self.script(PLOTTED)
        self.assertEqual(trace["name"], "mss-cf (2 curves)")
        shown = {self.key(place): y for place, y in zip(trace["places"], trace["y"])}
        cases = self.cases[(self.cases.test == "compression") & (self.cases.method == "mss-cf") & (self.cases["cells.x"] == 2)]
        cases = cases[(cases.solver == "static")]
        self.assertEqual(set(shown), set(cases.index))
        for key, deviation in cases.deviation_l2_relative.items():
            self.assertAlmostEqual(shown[key], 100 * deviation, delta=1e-12)
        self.assertNotIn("more are the same", self.one(".explorer .said").text)

    def test_hovering_shows_value_status_and_key_and_rings_in_all_panels(self):
        self.open("#explore?test=compression&x=nu&y=plate_force,volume_change,cell_volume_ratio_min")
        traces = self.script(PLOTTED)
        number = next(i for i, trace in enumerate(traces) if trace["name"] == "mss-cf" and trace["axis"] == "y2")
        self.point_at(number, 4)
        key = self.key(traces[number]["places"][4])
        case = self.cases.loc[key]
        label = self.one(".explorer .hoverlayer").text
        for text in (self.one(".readout").text, label):
            self.assertIn(f"case {key[:8]}", text)
            self.assertIn("ok", text)
            shown = float(re.search(r"volume change = (-?[\d.]+(e-?\d+)?) %", text)[1])
            self.assertAlmostEqual(shown, 100 * case.volume_change, delta=1e-10 * abs(case.volume_change))
        rings = self.browser.find_elements(By.CSS_SELECTOR, ".explorer .rings i")
        self.assertEqual(len(rings), 3)
        for name in ("plate force = ", "least V/V0 = "):
            self.assertIn(name, self.one(".readout").text)

    def test_a_click_shows_the_case(self):
        self.open("#explore?test=compression&x=nu&y=plate_force&m=mss-cf")
        traces = self.script(PLOTTED)
        number = 0
        self.point_at(number, 2)
        ActionChains(self.browser).click().perform()
        self.wait_for(lambda: self.one("#case").is_displayed(), "the case is shown")
        key = self.key(traces[number]["places"][2])
        text = self.one("#case").text
        self.assertIn(key, text)
        self.assertIn("springcheck run compression --method mss-cf", text)
        self.assertIn(str(self.cases.loc[key].plate_force), text)
        self.browser.switch_to.active_element.send_keys(Keys.ESCAPE)
        self.assertFalse(self.one("#case").is_displayed())
        self.assertIn("#explore?", self.script("return location.hash"))

    def test_commands_compute_their_cases_again(self):
        """All that the page prints: the same key comes out, or where no reference was, the same figures."""
        self.open("")
        self.assertEqual(self.script("return allCases.count"), len(self.cases))
        again = self.folder / "again.h5"
        commands = {self.key(place): self.script("return allCases.value('command', arguments[0])", place)
                    for place in range(len(self.cases))}
        is_sweep = (self.cases.scene == "compression") & (self.cases.solver == "static")
        is_sweep &= self.cases.method != "fem-cauchy-born"
        is_sweep &= (self.cases.reference == "fem-stvk:q1-sri") | (self.cases.method == "fem-hencky")
        few = self.cases.index[is_sweep][:8]
        self.assertGreaterEqual((~is_sweep).sum(), len(RUNS))
        for key in self.cases.index[~is_sweep].union(few):
            words = shlex.split(commands[key])
            self.assertEqual(words[:2], ["springcheck", "run"])
            springcheck("run", *words[2:], "--out", again, check=False)
            made = springcheck_results.read(again).cases
            case = self.cases.loc[key]
            if case.reference:
                self.assertIn(key, made.index, commands[key])
            else:
                self.assertTrue(same_figures(made, case).any(), commands[key])

    def test_a_case_without_a_reference_says_so(self):
        for is_alone in (True, False):
            key = self.cases.index[self.cases.reference.isna() == is_alone][0]
            self.open(f"#case={key[:12]}")
            self.assertEqual("computed without a reference" in self.one("#case").text, is_alone)

    def test_commands_name_only_what_the_scene_has_otherwise(self):
        self.open("")
        commands = self.script("return allCases.column('command').values")
        self.assertIn("springcheck run compression --method mss-cf --reference fem-stvk:q1-sri --cells 4,4,4 --nu 0 "
                      "--deformation 0.2", commands)

    def test_the_address_restores_the_choice(self):
        self.open("#explore?test=compression&x=nu")
        self.choose("x", "deformation")
        self.choose("fixed.nu", "0")
        self.tick("m", "mss-affine")
        self.tick("y", "cell_volume_ratio_min")
        self.tick("log-y", None)
        before, address = self.script(PLOTTED), self.script("return location.hash")
        self.assertGreater(len(before), 2)
        self.open(address)
        self.assertEqual(self.script(PLOTTED), before)
        self.assertEqual(self.script("return location.hash"), address)
        self.assertTrue(self.one(".explorer input[name=log-y]").is_selected())

    def test_a_choice_of_everything_is_restored(self):
        self.open("#explore?test=compression&x=nu")
        for name in ("fixed.cells", "fixed.load", "fixed.scene"):
            if self.script("return Boolean(document.querySelector('.explorer form').elements[arguments[0]])", name):
                self.choose(name, "")
        self.script("[...document.querySelectorAll('.explorer button')].find((one) => one.textContent === 'All methods').click()")
        time.sleep(1)
        before, address = self.script(PLOTTED), self.script("return location.hash")
        places = {place for trace in before for place in trace["places"]}
        self.assertEqual(len(places), ((self.cases.test == "compression").sum() - 1))  # one beside another reference
        self.open(address)
        self.assertEqual(self.script(PLOTTED), before)

    def test_up_to_four_measures_stand_side_by_side(self):
        five = "plate_force,volume_change,volume_error,strain_energy,cell_volume_ratio_min"
        self.open(f"#explore?test=compression&x=nu&y={five}&m=mss-cf")
        self.assertEqual([trace["axis"] for trace in self.script(PLOTTED)], ["y", "y2", "y3", "y4"])
        self.tick("y", "cell_volume_ratio_min")  # the newest stays, the first goes
        boxes = self.browser.find_elements(By.CSS_SELECTOR, ".explorer input[name=y]:checked")
        self.assertEqual({box.get_attribute("value") for box in boxes}, set(five.split(",")[1:]))

    def test_no_method_is_none(self):
        self.open("#explore?test=compression&x=nu&m=mss-cf")
        self.tick("m", "mss-cf")
        self.assertEqual(self.one(".explorer .said").text, "No case fits this choice.")
        self.open(self.script("return location.hash"))
        self.assertEqual(self.one(".explorer .said").text, "No case fits this choice.")

    def test_what_a_logarithmic_axis_cannot_show_is_said(self):
        self.open("#explore?test=uniaxial&x=deformation&log=x")
        self.assertIn("2 have no place on a logarithmic axis", self.one(".explorer .said").text)

    def test_from_a_case_back_to_the_choice(self):
        self.open("#explore?test=compression&x=nu&y=volume_change&m=mss-cf")
        before = self.script(PLOTTED)
        self.script("document.querySelector('.explorer .rows').open = true")
        self.wait_for(lambda: self.script("return document.querySelector('.explorer .rows a') !== null"), "rows")
        self.script("document.querySelector('.explorer .rows a').click()")
        self.wait_for(lambda: self.one("#case").is_displayed(), "the case is shown")
        self.open(self.script("return location.hash"))  # as a colleague who gets this address
        self.assertTrue(self.one("#case").is_displayed())
        self.browser.switch_to.active_element.send_keys(Keys.ESCAPE)
        self.script("document.querySelector('#explore').scrollIntoView()")
        self.wait_for(lambda: self.drawn() > 0, "the plot is drawn")
        self.assertEqual(self.script(PLOTTED), before)

    def test_a_case_that_the_page_opens_with_has_no_filters(self):
        """Those are of the page's own long tables, not of a case's."""
        self.open("")
        count = ("return Math.max(...['measure', 'setting'].map((role) => allCases.namesOf(role)"
                 ".filter((name) => allCases.value(name, arguments[0]) !== null).length))")
        rows = [self.script(count, place) for place in range(len(self.cases))]
        self.assertGreaterEqual(max(rows), 30)
        self.open(f"#case={self.key(rows.index(max(rows)))}")
        self.assertTrue(self.one("#case").is_displayed())
        self.assertEqual(self.browser.find_elements(By.CSS_SELECTOR, "body > input"), [])

    def test_going_back_closes_a_case(self):
        self.open("")
        self.script("location.hash = '#case=' + allCases.value('key', 0)")
        self.wait_for(lambda: self.one("#case").is_displayed(), "the case is shown")
        self.browser.back()
        self.wait_for(lambda: not self.one("#case").is_displayed(), "the case is closed")

    def test_odd_addresses_are_no_errors(self):
        for address in ("#case=%E0%A4%A", "#case=", "#explore?test=__proto__&x=constructor&y=toString&fixed.constructor=2"):
            self.open("")
            self.script("location.hash = arguments[0]", address)
            time.sleep(0.5)
        self.assertIn("test __proto__", self.one(".explorer .said").text)

    def test_what_an_address_asks_for_and_is_not_there_is_said(self):
        self.open("#explore?test=compression&x=nope&y=plate_force,bogus&m=mss-none&fixed.nu=7")
        said = self.one(".explorer .said").text
        for word in ("axis nope", "measure bogus", "method mss-none", "nu 7", "few.h5"):
            self.assertIn(word, said)
        self.assertGreater(len(self.script(PLOTTED)), 0)
        self.open("#case=0123abcd")
        self.assertIn("No case 0123abcd", self.one("#case").text)
        self.assertIn(f"few.h5 holds {len(self.cases)} cases, and none of that key", self.one("#case").text)

    def test_failed_cases_are_seen(self):
        self.open("#explore?test=compression&x=deformation&y=plate_force&fixed.nu=0&m=mss-nfd&m=mss-cf")
        bad = self.cases[(self.cases.test == "compression") & (self.cases.nu == 0) & (self.cases.status != "ok")]
        bad = bad[bad.method.isin(["mss-nfd", "mss-cf"])]
        self.assertGreater(len(bad), 0)
        self.assertIn(f"{(bad.status == bad.status.iloc[0]).sum()} {bad.status.iloc[0].replace('_', ' ')}",
                      self.one(".explorer .said").text)
        marked = {}
        for trace in self.script(PLOTTED):
            for i, place in enumerate(trace["places"]):
                symbol = trace["symbol"] if isinstance(trace["symbol"], str) else trace["symbol"][i]
                if trace["y"][i] is not None:
                    marked[self.key(place)] = symbol
        for key, case in bad.iterrows():
            self.assertTrue(marked[key].endswith("-open-dot" if case.plate_force == case.plate_force else "thin-open"))
        for key in set(marked) - set(bad.index):
            self.assertFalse(marked[key].endswith(("dot", "thin-open")))

    def test_the_csv_is_the_table_of_the_file(self):
        self.open("#explore?test=compression&x=nu&y=plate_force,volume_change")
        self.script("URL.createObjectURL = (blob) => { window.saved = blob; return 'data:,'; };"
                    "[...document.querySelectorAll('.explorer button')].find((one) => one.textContent === 'CSV').click()")
        text = self.browser.execute_async_script("window.saved.text().then(arguments[0])")
        rows = list(csv.DictReader(io.StringIO(text)))
        self.assertEqual({(self.cases.loc[row["key"]].method, float(row["nu"])) for row in rows}, self.usual_over_nu())
        self.assertEqual(len(rows), len(self.usual_over_nu()))
        for row in rows:
            case = self.cases.loc[row["key"]]
            self.assertEqual(row["status"], case.status)
            for column in ("nu", "plate_force", "volume_change"):
                self.assertEqual(float(row[column]), case[column])

    def test_pictures_are_saved(self):
        self.open("#explore?test=compression&x=nu&y=plate_force")
        for form, start in (("SVG", "data:image/svg+xml"), ("PNG", "data:image/png")):
            made = self.browser.execute_async_script(
                "Plotly.toImage(document.querySelector('.explorer .plot'), {format: arguments[0].toLowerCase()})"
                ".then(arguments[1])", form)
            self.assertTrue(made.startswith(start))
            self.assertGreater(len(made), 3000)

    def test_keyboard_alone(self):
        self.open("#explore?test=compression&x=nu")
        field = self.one(".explorer select[name=test]")
        self.script("arguments[0].focus()", field)
        before = self.drawn()
        field.send_keys("torsion")
        self.wait_for(lambda: self.drawn() > before, "torsion is drawn")
        self.assertEqual(self.script("return document.activeElement.name"), "test")  # the focus stays
        self.script("document.querySelector('.explorer .rows summary').focus()")
        self.browser.switch_to.active_element.send_keys(Keys.ENTER, Keys.TAB)
        self.wait_for(lambda: self.script("return document.querySelector('.explorer .rows table') !== null"), "rows")
        self.script("document.querySelector('.explorer .rows a').focus()")
        self.browser.switch_to.active_element.send_keys(Keys.ENTER)
        self.wait_for(lambda: self.one("#case").is_displayed(), "the case is shown")
        self.assertEqual(self.script("return document.activeElement.textContent"), "Close")

    def test_on_a_phone_it_fits(self):
        self.set_size(390, 844)
        self.open("#explore?test=compression&x=nu&y=plate_force,volume_change")
        self.script("for (const fold of document.querySelectorAll('.explorer details')) fold.open = true")
        self.assertLessEqual(self.script("return document.documentElement.scrollWidth"), 390)
        self.assertLessEqual(self.script("return document.querySelector('.explorer .plot').scrollWidth"), 390)

    def test_a_sweep_that_failed_throughout_has_a_page_that_shows_where(self):
        failed = self.folder / "failed"
        failed.mkdir()
        (self.folder / "failed.toml").write_text(
            'scene = "compression"\nmethod = "mss-lloyd"\ncells = [2, 2, 2]\nnu = [0, 0.1, 0.2]\n')
        springcheck("sweep", self.folder / "failed.toml", "--out", failed / "failed.h5", check=False)
        springcheck("report", failed / "failed.h5", "--out", failed)
        self.browser.get((failed / "index.html").as_uri() + "#explore")
        self.wait_for(lambda: self.drawn() > 0, "the plot is drawn")
        (trace,) = [trace for trace in self.script(PLOTTED) if any(y is not None for y in trace["y"])]
        self.assertEqual((trace["x"], trace["symbol"]), ([0, 0.1, 0.2], "x-thin-open"))
        self.assertIn("3 cases, of which 3 refused", self.one(".explorer .said").text)


if __name__ == "__main__":
    unittest.main()
