"""The page's section of speed against accuracy, from what the real program measures."""

import copy
import json
import re
import shutil
import sys
import tempfile
import unittest
from html import unescape
from pathlib import Path

REPORTS = Path(__file__).parents[2] / "reports"
sys.path[:0] = [str(Path(__file__).parent), str(REPORTS), str(REPORTS / "springcheck_report")]
import browser  # noqa: E402
import method_style  # noqa: E402
import page_text  # noqa: E402
import study as study_module  # noqa: E402
from content import Figure  # noqa: E402
from figures import work_precision  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from program import springcheck  # noqa: E402
from sections.answers.cost import cost_of_accuracy  # noqa: E402
from sections.chart import _heading, _number, chart  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402

# The finer mesh is beyond the second's fraction for some. Compressed by 35 % some fail, among them
# a grid of the truth of the scene's own law.
CHARTS = [
    "--sizes 2,3 --budget 0.004 --least-models 0 --on-threads 1,2",
    "--sizes 2 --budget 0.001 --least-models 0 --on-threads 1 --deformation 35%",
]
HOSTILE = r"a<b>&$\undefined{$/../x"
KINDS = ("equilibrium", "motion")


def figures_of(section):
    return {block.name: block for block in section.blocks if isinstance(block, Figure)}


def blocks_of(figure):
    return figure.arguments[1]


def key_of(point):
    return (point["model"], point["across"], point["threads"])


def key_drawn(point):
    return (point.model.name, point.across, point.threads)


class Charts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.file = cls.folder / "charts.h5"
        for options in CHARTS:
            springcheck("chart", "compression", "--converged-across", "1", *options.split(), "--out", cls.file)
        springcheck("report", cls.file, "--out", cls.folder)
        cls.charts = json.loads((cls.folder / "data" / "charts.json").read_text())
        cls.tables = {
            path.stem: json.loads(path.read_text()) for path in (cls.folder / "tables").glob("chart*.json")
        }
        page = (cls.folder / "index.html").read_text(encoding="utf-8")
        cls.page, cls.html = page, page_text.section(page, "chart")
        cls.study = study_module.read(cls.file, cls.folder)
        cls.figures = figures_of(chart(cls.study))

    def drawn(self):
        """(chart, kind, block) of every block of every figure."""
        for name, figure in self.figures.items():
            one = self.charts[1] if name.startswith("chart_compression_2") else self.charts[0]
            kind = next(kind for kind in KINDS if f"_{kind}" in name)
            for block in blocks_of(figure):
                yield one, kind, block

    def law_of(self, one, block):
        (law,) = (truth["law"] for truth in one["truths"] if block.title.endswith(f" {truth['law']}"))
        return law

    def test_the_page_has_the_charts_tables(self):
        for name in ("chart", "chart-converged", "chart-laws", "chart-front", "chart-claims"):
            self.assertTrue((self.folder / "tables" / f"{name}.csv").is_file(), name)
        self.assertEqual(self.charts[0]["scene"], "compression")

    def test_a_quick_chart_names_the_command_for_the_whole(self):
        self.assertNotIn("A quick chart", self.html)  # these have all models
        self.study.charts[0]["quick"] = True
        try:
            blocks = "".join(str(block) for block in chart(self.study).blocks)
        finally:
            self.study.charts[0]["quick"] = False
        models = {point["model"] for point in self.charts[0]["points"]}
        self.assertIn(f"A quick chart: {len(models)} models on ", blocks)
        self.assertIn("<code>springcheck chart compression --out charts.h5</code>", blocks)

    def bound(self, force):
        """Changes how far off the converged forces may be themselves."""
        before = copy.deepcopy(self.study.charts)
        self.addCleanup(self.study.charts.__setitem__, slice(None), before)
        for one in self.study.charts:
            for truth in one["truths"]:
                truth["bars"]["force"] = force

    def test_what_an_accuracy_costs(self):
        """The sentence by hand from charts.json."""
        self.bound(0.004)
        parts = []
        for one in self.charts:
            has_truth = any(truth["law"] == one["law"] for truth in one["truths"])
            fronts = [f for f in one["fronts"] if (f["kind"], f["law"], f["measure"]) == ("equilibrium", one["law"], "force")]
            if not has_truth or not fronts or not fronts[0]["points"]:
                continue
            for family in ("springs", "finite elements"):
                times = [
                    (p["median"], p["model"], p["across"], p["threads"])
                    for p in one["points"]
                    if p["kind"] == "equilibrium" and p["status"] == "ok" and p["median"] and p["family"] == family
                    and 0 < (p["errors"].get(one["law"], {}).get("force") or 1) <= 0.01
                ]
                parts.append((family, min(times, default=None), len({p["threads"] for p in one["points"]}) > 1))
        answer = cost_of_accuracy(self.study)
        text = re.sub("<[^>]*>", "", answer.sentence)
        law = re.escape(self.charts[0]["law"])
        self.assertRegex(
            text,
            "^Within 1 % of the force or torque to which the law named converges, by models of any law: "
            rf"compression, [^(]*\({law}\): ",
        )
        self.assertTrue(any(best for _, best, _ in parts))
        for family, best, is_threaded in parts:
            if best is None:
                self.assertIn(f"no {family} here", text)
                continue
            median, model, across, threads = best
            said = f", {threads} threads" if is_threaded else ""
            self.assertRegex(text, rf"{family} [\d.e+-]+ ms \({re.escape(model)}, {across} cells across{said}\)")
            shown = float(re.search(rf"{family} ([\d.e+-]+) ms \({re.escape(model)}", text)[1])
            self.assertAlmostEqual(shown, 1000 * median, delta=0.051 * 1000 * median)

    def test_a_force_that_is_known_badly_judges_nobody(self):
        self.bound(0.02)
        sentence = cost_of_accuracy(self.study).sentence
        self.assertIn("it is known to 2.0 % only", sentence)
        self.assertNotIn(" ms ", sentence)

    def test_both_kinds_have_figures_of_their_own(self):
        """Against the truth of the scene's own law, where it has one, and of the others."""
        names = [f"chart_compression_{kind}{laws}" for laws in ("", "_other-laws") for kind in KINDS]
        with_own = [
            "chart_compression_2_" + rest.removeprefix("chart_compression_")
            for rest in names
            if rest.endswith("laws") or self.charts[1]["law"] in {t["law"] for t in self.charts[1]["truths"]}
        ]
        self.assertEqual(list(self.figures), names + with_own)
        self.assertEqual(page_text.figures(self.html), names + with_own)
        for one, kind, block in self.drawn():
            models = {p["model"] for p in one["points"] if p["kind"] == kind}
            self.assertLessEqual({p.model.name for p in block.points}, models)

    def test_the_front_is_that_of_the_file(self):
        seen = 0
        for one, kind, block in self.drawn():
            for measure in block.measures:
                (front,) = (
                    f for f in one["fronts"]
                    if (f["kind"], f["law"], f["measure"]) == (kind, self.law_of(one, block), measure.name)
                )
                points = [one["points"][place] for place in front["points"]]
                self.assertEqual([key_drawn(p) for p in measure.front], [key_of(p) for p in points])
                self.assertEqual([p.time for p in measure.front], [p["median"] for p in points])
                seen += 1
        self.assertGreater(seen, 20)
        for count, one in enumerate(self.charts, 1):
            if all(truth["law"] != one["law"] for truth in one["truths"]):
                continue
            name = "chart_compression" if count == 1 else f"chart_compression_{count}"
            own = [f for f in one["fronts"] if f["law"] == one["law"]]
            expected = [
                [f"{f['kind']}: {f['measure']}", p["model"], str(p["across"]), str(p["threads"])]
                for f in own for p in (one["points"][place] for place in f["points"])
            ]
            self.assertEqual([row[:4] for row in page_text.rows(self.html, f"front-{name}")], expected)

    def test_every_timed_point_on_the_fewest_threads_is_drawn(self):
        """Failed ones as well, with their statuses; errors are those of the block's law."""
        failed = set()
        for one, kind, block in self.drawn():
            law = self.law_of(one, block)
            expected = {
                key_of(p): p for p in one["points"]
                if p["kind"] == kind and p["threads"] == 1 and p["median"] is not None
            }
            self.assertEqual({key_drawn(p) for p in block.points}, set(expected))
            for point in block.points:
                stored = expected[key_drawn(point)]
                self.assertEqual(point.status, stored["status"])
                failed |= {point.status} - {"ok"}
                for measure, error in stored["errors"][law].items():
                    self.assertEqual(point.errors[measure], None if error is None else 100 * error)
        self.assertTrue(failed)

    def test_failed_points_are_crosses_above_the_errors(self):
        """Of the drawn panels, at their times, in the model's colour where it has a row."""
        method_style.set_defaults()
        for name, figure in self.figures.items():
            if not any(p.status != "ok" for block in blocks_of(figure) for p in block.points):
                continue
            drawn = figure.draw(*figure.arguments)
            below = [artist for artist in drawn.artists if isinstance(artist, Line2D)]
            lines = [*below, *(line for panel in drawn.axes for line in panel.lines)]
            crosses = {
                (float(x), line.get_color(),
                 line.get_clip_box().contains(*line.get_transform().transform((x, y))))
                for line in lines if line.get_marker() == "x"
                for x, y in zip(line.get_xdata(), line.get_ydata())
            }
            texts = {text.get_text() for panel in drawn.axes for text in panel.texts}
            for block in blocks_of(figure):
                in_rows = {model for group in block.groups for model in group.models}
                for point in block.points:
                    if point.status == "ok":
                        continue
                    self.assertIn(point.status.replace("_", " "), texts)
                    self.assertIn(point.time, {x for x, _, is_inside in crosses if is_inside})
                    if point.model in in_rows:
                        colour = work_precision.style(point.model)["color"]
                        self.assertIn((point.time, colour, True), crosses, (name, point.model))
            return
        self.fail("no figure has failed points")

    def test_what_failed_or_was_not_run_is_named(self):
        over = {p["model"] for p in self.charts[0]["points"] if p["median"] is None}
        self.assertTrue(over)
        text = unescape(self.html)
        sentence = text[text.index("Not run, over budget") :]
        sentence = sentence[: sentence.index("</p>")]
        for model in over:
            self.assertIn(f"{model} on <data", sentence)
        for point in self.charts[1]["points"]:
            if point["median"] is not None and point["status"] != "ok":
                sentence = text[text.index(f"Failed, {point['status'].replace('_', ' ')}<") :]
                self.assertIn(point["model"], sentence[: sentence.index("</p>")])

    def test_numbers_are_those_of_the_tables(self):
        """Each of a row of its table and that row's case; the text is the number, rounded."""
        numbers = page_text.numbers(self.html)
        self.assertGreater(len(numbers), 100)
        self.assertEqual({n["data-table"] for n in numbers}, {"chart", "chart-front", "chart-converged"})
        for number in numbers:
            rows = self.tables[number["data-table"]]["rows"]
            if "data-case" in number:
                rows = [row for row in rows if row["case"] == number["data-case"]]
            else:  # not run: no case of the file
                rows = [row for row in rows if row["median"] is None]
            self.assertTrue(any(float(number["value"]) in row.values() for row in rows), number)
            shown = float(number["text"].split()[0])
            self.assertAlmostEqual(shown, float(number["value"]), delta=0.051 * abs(shown) + 1e-12)
        named = {number["data-case"] for number in numbers if "data-case" in number}
        self.assertGreater(len(named), 10)
        self.assertLessEqual(named, set(self.study.results.cases.index), "cases of the file")

    def test_claims_are_the_programs_own_words(self):
        words = [claim["words"] for one in self.charts for claim in one["claims"]]
        self.assertTrue(words)
        for text in words:
            self.assertIn(text, unescape(self.html))

    def test_the_machine_the_threads_and_a_missing_truth_are_said(self):
        for one in self.charts:
            self.assertIn(one["machine"], unescape(self.html))
        self.assertTrue(all("medians on one thread" in f.caption for f in self.figures.values()))
        laws = {truth["law"] for truth in self.charts[1]["truths"]}
        missing = f"{self.charts[1]['law']}, the scene's own law, has no converged solution here"
        self.assertEqual(missing in unescape(self.html), self.charts[1]["law"] not in laws)

    def test_headings_tell_charts_of_the_same_load_apart(self):
        one, other = self.study.charts[0], copy.deepcopy(self.study.charts[0])
        alike = copy.copy(self.study)
        alike.charts = [one, other]
        self.assertEqual(_heading(alike, one), _heading(self.study, one))
        other["machine"] = "another machine"
        self.assertTrue(_heading(alike, other).endswith(", on another machine"))
        other["machine"] = one["machine"]
        other["truths"][0]["finest_cell_size"] = 0.001
        self.assertTrue(_heading(alike, other).endswith(", converged on cells down to 1 mm"))

    def test_words_stand_where_a_number_is_lacking(self):
        document = {"table": "chart-converged"}
        for found, shown in (("not checked", "not checked"), (None, "none")):
            row = {"answer_apart": found, "case": None}
            self.assertEqual(_number(document, row, "answer_apart", "{:.2g}"), shown)

    def test_one_section_has_the_title(self):
        self.assertEqual(self.page.count("<h2>Speed against accuracy</h2>"), 1)

    def test_names_are_text(self):
        hostile = copy.copy(self.study)
        hostile.charts = copy.deepcopy(self.study.charts[:1])
        hostile.charts[0]["scene"] = hostile.charts[0]["machine"] = HOSTILE
        hostile.charts[0]["points"][0]["model"] = HOSTILE
        hostile.tables = copy.deepcopy(self.study.tables)
        for row in hostile.tables["chart"]["rows"]:
            row["model"] = HOSTILE
        section = chart(hostile)
        html = "".join(str(block) for block in section.blocks if not isinstance(block, Figure))
        self.assertNotIn("<b>&", html)
        self.assertIn("a&lt;b&gt;&amp;", html)
        for name in figures_of(section):
            self.assertRegex(name, r"^[A-Za-z0-9._-]+$")
        first = next(iter(figures_of(section).values()))
        first.draw(*first.arguments).canvas.draw()  # matplotlib would take the name for a formula

    def test_the_browser_draws_it_without_complaint(self):
        driver = browser.chromium(webgl=False)
        self.addCleanup(driver.quit)
        driver.get((self.folder / "index.html").as_uri())
        driver.execute_script("document.querySelectorAll('#chart details').forEach((e) => { e.open = true; })")
        images = driver.find_elements(By.CSS_SELECTOR, "#chart figure img")
        self.assertEqual(len(images), len(self.figures))
        for image in images:
            browser.show(driver, image)
            self.assertGreater(browser.drawn_share(browser.pixels(image)), 0.03, image.get_attribute("alt"))
        for link in driver.find_elements(By.CSS_SELECTOR, "#chart a"):
            self.assertTrue((self.folder / link.get_dom_attribute("href")).is_file())
        self.assertLessEqual(driver.execute_script("return document.documentElement.scrollWidth"), 1300)
        self.assertEqual(driver.get_log("browser"), [])


if __name__ == "__main__":
    unittest.main()
