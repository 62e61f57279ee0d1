"""The page's section of dynamics, from what the real program writes."""

import json
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

REPORTS = Path(__file__).parents[2] / "reports"
sys.path[:0] = [str(Path(__file__).parent), str(REPORTS), str(REPORTS / "springcheck_report")]
import page_text  # noqa: E402
import study as study_module  # noqa: E402
from program import springcheck  # noqa: E402
from sections.histories import histories  # noqa: E402

SMALL = "--nu 0.25 --cells 4,4,4"
MOTION = "--solver verlet --damping 0.1 --duration 0.5 --history 40"
DEFORMED = {
    "compression": "5% --cells 4,4,4",
    "tension": "5% --cells 2,2,12",
    "shearing": "5% --cells 4,4,4",
    "torsion": "10deg --cells 4,4,4",
    "uniaxial": "-5% --cells 4,4,4",
}


def page_in(folder):
    return (folder / "index.html").read_text(encoding="utf-8")


class Cases(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.file = cls.folder / "small.h5"
        for scene, amount in DEFORMED.items():
            for more in (f"--method mss-cf,mss-nfd {MOTION}", "--method mss-cf"):
                run = f"run {scene} --nu 0.25 --deformation {amount} {more} --out"
                springcheck(*run.split(), cls.file)
        explicit = f"run compression --deformation 5% {SMALL} --method"
        springcheck(*f"{explicit} fem-explicit-8p --duration 0.5 --out".split(), cls.file)
        springcheck(*f"{explicit} fem-stvk --element q1 --out".split(), cls.file)
        raw = f"run compression-thesis-raw --deformation 5% {SMALL} --history 40 --out"
        springcheck(*raw.split(), cls.file)
        early = "--method mss-cf --solver verlet --damping 0.3 --load-times 2 --load-fractions 0.5"
        springcheck(*f"run shearing --deformation 10% {SMALL} {early} --history 40 --out".split(), cls.file)
        springcheck(*f"run bending --cells 2,2,12 {early} --out".split(), cls.file)
        back = f"{SMALL} --method mss-cf"
        pulled = "--solver verlet --damping 0.3 --load-times 1,1.5 --load-fractions=-0.5,-0.5 --history 20"
        springcheck(*f"run uniaxial --deformation -5% {back} {pulled} --out".split(), cls.file)
        springcheck(*f"run uniaxial --deformation 2.5% {back} --out".split(), cls.file)
        springcheck("report", cls.file, "--out", cls.folder)
        cls.section = page_text.section(page_in(cls.folder), "through-time")
        cls.study = study_module.read(cls.file, cls.folder)

    def through_time(self):
        return self.study.cases[self.study.cases.apply(study_module.is_through_time, axis=1)]

    def test_a_history_ends_at_the_measures_of_its_case(self):
        """Read by the columns' names: exact, the last sample is the end."""
        cases = self.through_time()
        seen = set()
        for key, case in cases[cases.method == "mss-cf"].iterrows():
            history = self.study.history(key)
            if history is None:
                continue
            seen.add(case.test)
            self.assertEqual(len(history), 40)
            self.assertEqual(history.time.iloc[-1], case.duration)
            self.assertEqual(history.kinetic_energy.iloc[-1], case.kinetic_energy)
            self.assertEqual(history.volume_change.iloc[-1], case.volume_change)
            # The case's own is along the load as it ends.
            turned = -1 if case.load_fraction < 0 else 1
            self.assertEqual(history.answer.iloc[-1], turned * case.answer, case.test)
        self.assertEqual(seen, set(DEFORMED))

    def test_every_case_through_time_stands_beside_its_statics(self):
        rows = page_text.rows(self.section, "solvers")
        cases = self.through_time()
        self.assertEqual(len(rows), len(cases))
        statics = self.study.cases[self.study.cases.solver == "static"]
        beside = 0
        for _, method, solver, end, still, off, *_, key in rows:
            (place,) = (k for k in cases.index if k.startswith(key))
            case = cases.loc[place]
            self.assertEqual((method, solver), (case.method, case.solver))
            self.assertAlmostEqual(float(end.split()[0]), case.answer, delta=1e-4 * abs(case.answer))
            law = {"mss-cf": "mss-cf", "fem-explicit-8p": "fem-stvk"}.get(method)
            same = statics[(statics.problem == case.problem) & (statics.method == law)]
            self.assertEqual(bool(still), len(same) > 0)
            if still:
                beside += 1
                difference = 100 * (case.answer / same.answer.iloc[0] - 1)
                self.assertAlmostEqual(float(off), difference, delta=0.00051)
        self.assertEqual(beside, len(DEFORMED) + 3)

    def test_a_motion_that_ends_early_stands_beside_its_last_load(self):
        """Half of a shear by 10 %, slow and damped, is one by 5 %: 1 % is what moves."""
        rows = page_text.rows(self.section, "solvers")
        (sheared,) = (row for row in rows if ", 5 % at its end" in row[0])
        self.assertLess(abs(float(sheared[5])), 1)
        theory = json.loads((self.folder / "data" / "theory.json").read_text(encoding="utf-8"))
        self.assertEqual([beam["gravity"] for beam in theory["beams"]], [5])
        cases = (self.folder / "tables" / "cases.md").read_text(encoding="utf-8")
        self.assertIn("Ends at 50 % of the load.", cases)
        self.assertIn("Ends at -50 % of the load.", cases)

    def test_rings_are_where_and_as_a_path_ended(self):
        """Pulled where the load presses, and then held: 2 % is what moves."""
        (figure,) = (f for f in histories(self.study) if f.name == "history_uniaxial")
        force, *_ = figure.arguments[0]
        (curve,) = (c for c in force.curves if len(c.x) > 1 and c.x[-1] == 1.5)
        (ring,) = (c for c in force.curves if "at rest" in c.name and c.x[0] == 1.5)
        self.assertLess(ring.y[0], 0)
        self.assertAlmostEqual(ring.y[0] / curve.y[-1], 1, delta=0.02)

    def test_numbers_are_those_of_the_file(self):
        numbers = [n for n in page_text.numbers(self.section) if "data-measure" in n]
        self.assertGreater(len(numbers), 50)
        for number in numbers:
            stored = self.study.cases.loc[number["data-case"], number["data-measure"]]
            self.assertEqual(float(number["value"]), stored)

    def test_histories_have_figures(self):
        drawn = [name for name in page_text.figures(self.section) if name.startswith("history_")]
        self.assertEqual(sorted(drawn), sorted(f"history_{test}" for test in DEFORMED))
        for name in drawn:
            self.assertGreater((self.folder / "figures" / f"{name}.svg").stat().st_size, 10_000)

    def test_bodies_of_the_thesis_s_units_are_drawn_over_their_size(self):
        """A hundred times larger, yet at the end of a slow motion the same body: to the few
        percent of the waves in it."""
        (figure,) = (f for f in histories(self.study) if f.name == "history_compression")
        force, *_ = figure.arguments[0]
        self.assertIn("E A", force.y_label)
        ends = {curve.name: curve.y[-1] for curve in force.curves}
        (raw,) = (value for name, value in ends.items() if "thesis-raw" in name)
        self.assertAlmostEqual(raw / ends["mss-cf at rest"], 1, delta=0.1)

    def test_what_the_file_lacks_has_no_section(self):
        page = page_in(self.folder)
        self.assertIsNone(page_text.section(page, "speed"))
        self.assertIsNone(page_text.section(page, "modes"))


if __name__ == "__main__":
    unittest.main()
