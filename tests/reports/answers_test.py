"""The page's answers in pictures: every figure of their sentences, against the result file.
SPRINGCHECK names the program."""

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
import numpy as np  # noqa: E402
import page_text  # noqa: E402
import springcheck_results  # noqa: E402
import study as study_module  # noqa: E402
from program import springcheck  # noqa: E402
from sections.answers.cost import cost_of_accuracy  # noqa: E402
from sections.answers.limits import first_failures  # noqa: E402

SWEEP = """
fields = true
[[cases]]
scene = "compression"
method = ["mss-cf", "mss-hencky", "fem-hencky"]
cells = [3, 3, 3]
nu = [0, 0.25, 0.45]
[[cases]]
scene = "torsion"
method = ["mss-cf", "mss-hencky", "mss-affine-stvk", "fem-hencky", "fem-stvk"]
cells = [3, 3, 3]
deformation = "40deg"
"""
MAP = "compression --cells 3,3,3 --method mss-cf,mss-hencky,fem-hencky --over deformation=20%:60%:3 --over nu=0,0.4"


def text_of(sentence):
    return unescape(re.sub("<[^>]*>", "", sentence))


def two_digits(value):
    """As the page writes it."""
    return f"{value:#.2g}".removesuffix(".")


class Answers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.file = cls.folder / "few.h5"
        (cls.folder / "few.toml").write_text(SWEEP)
        springcheck("sweep", cls.folder / "few.toml", "--out", cls.file)
        springcheck("stability", *MAP.split(), "--out", cls.file)
        springcheck("report", cls.file, "--out", cls.folder)
        page = (cls.folder / "index.html").read_text(encoding="utf-8")
        cls.summary = page_text.section(page, "summary")
        cls.results = springcheck_results.read(cls.file)
        cls.cases = cls.results.cases[cls.results.cases.solver != "limit"]
        cls.study = study_module.read(cls.file, cls.folder)

    def sentence(self, name):
        figure = re.search(rf'<figure id="figure-answer_{name}">.*?<p>(.*?) <a href', self.summary, re.DOTALL)
        return figure.group(1)

    def case(self, method, **conditions):
        cases = self.cases[self.cases.method == method]
        for column, value in conditions.items():
            cases = cases[cases[column] == value]
        return cases.iloc[0]

    def test_questions_without_data_are_not_asked(self):
        questions = re.findall(r"<h3>([^<]*\?)</h3>", self.summary)
        self.assertEqual(questions, ["How far are springs from finite elements?", "Where do they fail?",
                                     "What do the bodies look like?"])
        self.assertIsNone(cost_of_accuracy(self.study))  # there is no chart

    def test_distance_over_nu(self):
        ranges = {}
        for method in ("mss-cf", "mss-hencky"):
            found = []
            for nu in (0, 0.25, 0.45):
                at = {"test": "compression", "nu": nu, "deformation": 0.05}
                theirs = self.case("fem-hencky", **at).plate_force
                found.append(100 * abs(self.case(method, **at).plate_force - theirs) / abs(theirs))
            ranges[method] = f"{method} is {two_digits(min(found))} to {two_digits(max(found))} %"
        self.assertEqual(
            text_of(self.sentence("distance")),
            f"Pressed by 5 % (3×3×3 hexahedra): the plate force of {ranges['mss-cf']}, of {ranges['mss-hencky']} off finite "
            "elements on the same mesh, over Poisson's ratios from 0 to 0.45.",
        )

    def test_numbers_carry_their_cases(self):
        numbers = page_text.numbers(self.sentence("distance"))
        self.assertEqual(len(numbers), 4)
        for number in numbers:
            case = self.cases.loc[number["data-case"]]
            self.assertEqual((case.test, case.deformation), ("compression", 0.05))
            theirs = self.case("fem-hencky", test="compression", nu=case.nu, deformation=0.05).plate_force
            off = 100 * abs(case.plate_force - theirs) / abs(theirs)
            self.assertAlmostEqual(float(number["value"]), off, delta=1e-12 * off)

    def test_limits_are_those_of_the_map(self):
        maps = json.loads((self.folder / "data" / "atlas.json").read_text())["maps"]
        words = []
        for method in ("mss-cf", "mss-hencky", "fem-hencky:q1-sri"):
            limits = [limit for limit in maps[0]["limits"] if limit["method"] == method]
            least = min(limits, key=lambda limit: limit["low"])
            if least["high"] is None:
                words.append(f"{method} at least to {two_digits(least['low'])} %")
            else:
                words.append(f"{method} to {two_digits(least['low'])} % (then {least['failure']})")
        self.assertEqual(
            text_of(self.sentence("limits")),
            f"Pressed further and further (3×3×3 hexahedra), at every Poisson's ratio from 0 to 0.4 these stay stable: "
            f"{', '.join(words)}.",
        )
        self.assertIn("at least to", " ".join(words))  # elements

    def changed(self, change):
        """The sentence of the map's limits after a change of the map; None where there is none."""
        before = copy.deepcopy(self.study.atlas)
        try:
            change(self.study.atlas["maps"][0])
            answer = first_failures(self.study)
        finally:
            self.study.atlas.clear()
            self.study.atlas.update(before)
        return answer and text_of(answer.sentence)

    def test_methods_that_are_stable_nowhere_or_do_not_cover_the_map(self):
        def nowhere(one):
            one["limits"][0] |= {"low": None, "failure": "wrinkling"}

        def not_covered(one):
            for limit in one["limits"]:
                if limit["method"] == "mss-cf":
                    limit |= {"low": None, "failure": "not covered"}

        def partly_covered(one):
            one["limits"][0] |= {"low": None, "failure": "not covered"}

        self.assertIn("these stay stable: mss-cf nowhere (wrinkling), mss-hencky", self.changed(nowhere))
        self.assertIn("these stay stable: mss-hencky", self.changed(not_covered))
        self.assertRegex(self.changed(partly_covered), r"ratio that it covers from 0 to 0.4 these stay stable: .*mss-cf to ")

    def test_maps_of_which_there_is_no_such_answer(self):
        def other_axis(one):
            one["axes"][0]["key"] = "dt-ratio"

        def of_pressing(one):  # uniaxial: the more negative the further
            one["axes"][0]["numbers"] = [-60.0, -40.0, -20.0]

        def of_names(one):
            one["axes"][1]["numbers"] = None

        def of_nothing(one):
            one["limits"].clear()

        for change in (other_axis, of_pressing, of_names, of_nothing):
            self.assertIsNone(self.changed(change), change)

    def test_a_map_of_another_test_names_the_scene(self):
        file = self.folder / "uniaxial.h5"
        springcheck("stability", *"uniaxial --cells 2,2,2 --method mss-cf --over deformation=5%,9% --over nu=0,0.4".split(),
                    "--out", file)
        springcheck("report", file, "--out", self.folder / "uniaxial")
        page = (self.folder / "uniaxial" / "index.html").read_text(encoding="utf-8")
        self.assertIn("Uniaxial further and further (2×2×2 hexahedra), at every", text_of(page))

    def test_distances_of_bodies(self):
        """Torsion shows most; mss-affine-stvk has a judge of its own law, so it is not named."""
        theirs = self.results.fields(self.case("fem-hencky", test="torsion").name)["displacement"]
        texts = []
        for method in ("mss-cf", "mss-hencky"):
            case = self.case(method, test="torsion")
            apart = np.linalg.norm(self.results.fields(case.name)["displacement"] - theirs, axis=1)
            nodes = self.results.mesh(case.name)["nodes"]
            is_outside = ((nodes == nodes.min(axis=0)) | (nodes == nodes.max(axis=0))).any(axis=1)
            texts.append(f"{method} up to {two_digits(1000 * apart[is_outside].max())} mm")
        moved = two_digits(1000 * np.linalg.norm(theirs, axis=1).max())
        self.assertEqual(
            text_of(self.sentence("bodies")),
            f"Turned by 40°: points of {texts[0]}, of {texts[1]} from those of fem-hencky:q1-sri, which move by up "
            f"to {moved} mm.",
        )

    def test_who_made_it_from_what(self):
        made = re.search(r"Made by springcheck (\S+) \(commit (\S+)\) from few.h5: (\d+) cases", self.summary)
        session = self.results.provenance.sort_values("date").iloc[-1]
        self.assertEqual(made.groups(), (session.springcheck, session.commit, str(len(self.results.cases))))

    def test_cells_say_what_they_are(self):
        """By the words above the table, which names the judges."""
        table = page_text.rows(self.summary, "summary-small")
        self.assertEqual([cell for row in table for cell in row if cell in ("", "–")], [])
        self.assertRegex(table[0][1], r"^[\d.]+ % up to [\d.]+ % 3 of 3$")  # mss-cf in compression
        text = text_of(self.summary)
        self.assertIn("below it the largest, which leads to its case, and how many of the cases are usable", text)
        self.assertIn("lock: fem-hencky:q1-sri, fem-stvk:q1-sri, of the law", text)


if __name__ == "__main__":
    unittest.main()
