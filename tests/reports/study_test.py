"""What cases are compared with, and what the page says of them; on made-up cases."""

import json
import sys
import types
import unittest
from pathlib import Path

REPORTS = Path(__file__).parents[2] / "reports"
sys.path[:0] = [str(REPORTS), str(REPORTS / "springcheck_report")]
import measures  # noqa: E402
import methods  # noqa: E402
import numpy as np  # noqa: E402
import pandas as pd  # noqa: E402
import study as study_module  # noqa: E402
from case_words import case_text  # noqa: E402
from program import springcheck  # noqa: E402
from sections.failures import failing_sentences, failures  # noqa: E402
from sections.summary import _force, against_print  # noqa: E402
from sections.thesis_tables import relative_size  # noqa: E402

VOCABULARY = json.loads(springcheck("list", "--json").stdout)
SETTINGS = VOCABULARY["settings"]
methods.learn(VOCABULARY)
measures.learn(VOCABULARY)


class Stub:
    """A study of cases alone."""

    def __init__(self, cases):
        self.cases, self.theory = cases, {}
        self.distinct = cases[~cases.is_repeated]


def cases_of(*rows):
    usual = {
        "scene": "compression", "test": "compression", "method": "mss-cf", "status": "ok",
        "body": "block", "cell-type": "hexahedron", "mesh": "m", "nu": 0.25, "young": 1e4,
        "density": 1e3, "deformation": 0.05, "solver": "static", "cells.x": 4.0, "cells.y": 4.0,
        "cells.z": 4.0, "size.z": 0.05, "volume_change": -0.03, "plate_force": 1.0,
    }
    table = pd.DataFrame([{**usual, **row} for row in rows])
    for name in table.columns[table.dtypes == object]:  # as the reader has it
        table[name] = table[name].where(table[name].notna(), None)
    table.index = [f"key{i}" for i in range(len(rows))]
    return study_module.prepared(table, SETTINGS)


def fem(law, element, **further):
    return {"method": f"fem-{law}", "element": element, **further}


class Failures(unittest.TestCase):
    def test_failed_cases_on_users_meshes_alone_have_a_section(self):
        failed = {"body": "file", "cell-type": None, "status": "refused"}
        study = Stub(cases_of(failed, {**failed, "nu": 0.3}, {"body": "file", "cell-type": None}))
        study.atlas = {}
        self.assertGreater(len(failures(study).blocks), 1)

    def test_how_far_a_case_came_is_told(self):
        given_up = {"status": "not_converged", "load_fraction": 0.25}
        study = Stub(cases_of(given_up, {"status": "wrinkled", "load_fraction": 1.0}))
        study.atlas = {}
        text = str(failures(study).blocks[-1])
        self.assertEqual(text.count("25.0 % of the load"), 1)
        self.assertNotIn("100 % of the load", text)



class Loads(unittest.TestCase):
    def test_a_path_that_ends_early_is_a_problem_at_its_end(self):
        half = {"solver": "verlet", "deformation": 0.1, "load_fraction": 0.5}
        failed = {**half, "status": "diverged"}
        limit = {**half, "solver": "limit", "status": "indefinite"}
        cases = cases_of(half, fem("stvk", "q1-sri"), failed, limit)
        self.assertEqual(list(cases.counterpart[:3]), ["key1", None, None])
        self.assertEqual(list(cases.deformation), [0.05, 0.05, 0.1, 0.1])
        self.assertEqual(list(cases.load), ["5 % at its end", "5 %", "10 %", "10 %"])
        self.assertEqual(cases.whole_deformation.iloc[0], 0.1)
        beam = {**half, "test": "bending", "deformation": np.nan, "gravity.x": -10.0}
        cases = cases_of(beam)
        self.assertEqual(cases["gravity.x"].iloc[0], -5)
        self.assertEqual(cases.load.iloc[0], "E = 0.01 MPa, 50 % of its weight")


class Further(unittest.TestCase):
    def test_cases_that_read_alike_are_told_apart(self):
        cases = cases_of({"density": 1000.0}, {"density": 1060.0}, {"nu": 0.3}, fem("stvk", "q1"))
        self.assertEqual(list(cases.further), ["density 1000", "density 1060", "", ""])
        self.assertEqual(
            case_text(cases.iloc[1]),
            case_text(cases.iloc[0]).replace("1000", "1060"),
        )
        self.assertFalse(cases.is_repeated.any())

    def test_the_same_with_another_reference_is_repeated(self):
        cases = cases_of({"reference": "fem-stvk"}, {"reference": "fem-hencky"})
        self.assertEqual(list(cases.further), ["", ""])
        self.assertEqual(list(cases.is_repeated), [False, True])


class Counterparts(unittest.TestCase):
    def test_hencky_before_others_and_no_element_that_locks(self):
        cases = cases_of({}, fem("stvk", "q1-sri"), fem("hencky", "q1"), fem("hencky", "q1-sri"))
        self.assertEqual(list(cases.counterpart), ["key3", None, None, None])
        self.assertTrue(cases.is_judged.iloc[0])

    def test_springs_that_follow_a_law_are_judged_by_it(self):
        springs = {"method": "mss-stvk"}
        cases = cases_of(springs, fem("stvk", "q1"), fem("stvk", "q1-sri"), fem("hencky", "q1-sri"))
        self.assertEqual(cases.counterpart.iloc[0], "key2")
        self.assertTrue(cases.is_judged.iloc[0])
        self.assertEqual(cases_of(springs, fem("hencky", "q1-sri")).counterpart.iloc[0], "key1")

    def test_problems_differ_by_any_setting(self):
        for change in ({"nu": 0.3}, {"deformation": 0.2}, {"mesh": "n"}, {"young": 2e4}):
            cases = cases_of({}, fem("hencky", "q1-sri", **change))
            self.assertIsNone(cases.counterpart.iloc[0])

    def test_a_failed_solution_is_no_counterpart(self):
        cases = cases_of({}, fem("hencky", "q1-sri", status="no_equilibrium"))
        self.assertIsNone(cases.counterpart.iloc[0])

    def test_linear_elements_judge_nothing(self):
        for shape in ({"cell-type": "free-tetrahedron"}, {"body": "kidney"}):
            cases = cases_of(shape, fem("hencky", "q1", **shape))
            self.assertEqual(cases.counterpart.iloc[0], "key1")
            self.assertFalse(cases.is_judged.iloc[0])
        self.assertFalse(cases_of({}, fem("hencky", "q1")).is_judged.iloc[0])

    def test_differences(self):
        cases = cases_of(
            {"plate_force": 0.9, "volume_change": -0.031}, fem("hencky", "q2", plate_force=1.2)
        )
        self.assertAlmostEqual(cases.answer_difference.iloc[0], -0.25)
        self.assertAlmostEqual(cases.volume_difference.iloc[0], -0.001)
        self.assertTrue(np.isnan(cases.answer_difference.iloc[1]))

    def test_answers_are_of_the_test(self):
        row = {"plate_force": 1, "plate_force_norm": 2, "plate_torque": 3, "tip_deflection": 0.01}
        cases = cases_of(*({**row, "test": t} for t in ("tension", "shearing", "torsion", "bending")))
        self.assertEqual(list(cases.answer), [1, 2, 3, 0.01])
        self.assertAlmostEqual(cases.strain.iloc[3], 0.2)  # of a beam tip over length

    def test_the_same_simulation_with_another_reference_counts_once(self):
        cases = cases_of({"reference": "a"}, {"reference": "b"}, {"method": "mss-nfd"})
        self.assertEqual(list(cases.is_repeated), [False, True, False])


class Words(unittest.TestCase):
    def test_names_tell_settings(self):
        cases = cases_of(
            {"stiffness-form": "E"},
            {"diagonal-ratio": 0.5},
            {"diagonal-ratio": 1.0},
            {"spring-strain": "green"},
            {"spring-strain": "engineering"},
            {"solver": "explicit"},
            fem("cauchy-born", "q2", lattice="mss-affine"),
            {"method": "mine", "source": "measured"},
        )
        names = [
            *("mss-cf, E-form", "mss-cf, A = 0.5", "mss-cf", "mss-cf, green", "mss-cf"),
            *("mss-cf, explicit", "fem-cauchy-born:q2 (mss-affine)", "mine"),
        ]
        self.assertEqual(list(cases["name"]), names)
        self.assertEqual(cases.kind.iloc[-1], "measured")

    def test_loads(self):
        cases = cases_of({}, {"test": "torsion", "deformation": np.pi / 4}, {"test": "bending"})
        self.assertEqual(list(cases.load), ["5 %", "45°", "E = 0.01 MPa"])

    def test_failures_are_told_with_the_mildest(self):
        bad = {"method": "mss-nfd", "status": "wrinkled"}
        beam = {**bad, "test": "bending", "scene": "bending", "tip_deflection": 0.02}
        cases = cases_of({}, {**bad, "deformation": 0.2}, {**bad, "deformation": 0.02}, beam)
        (sentence,) = failing_sentences(Stub(cases))
        self.assertIn("in 3 of 3 cases (compression, bending; mildest: compression", sentence)
        self.assertIn("2 %)", sentence)
        self.assertEqual(failing_sentences(Stub(cases_of({}))), ["In none of these cases."])

    def test_failures_of_other_settings_are_counted_apart(self):
        other = {"method": "mss-nfd", "stiffness-form": "E", "status": "wrinkled", "deformation": 0.01}
        usual = {"method": "mss-nfd", "status": "wrinkled", "deformation": 0.2}
        others = (other, {**other, "nu": 0.3, "status": "ok"})
        (sentence,) = failing_sentences(Stub(cases_of({"method": "mss-nfd"}, usual, *others)))
        self.assertIn("in 1 of 2 cases (compression; mildest: compression", sentence)
        self.assertIn("20 %); with other settings or in motion fails in 1 of 2 cases.", sentence)
        (sentence,) = failing_sentences(Stub(cases_of(other)))
        self.assertIn("in 1 of 1 cases", sentence)

    def test_where_a_method_covers_nothing_with_its_usual_settings_others_are_told(self):
        other = {"method": "mss-nfd", "stiffness-form": "E", "status": "wrinkled", "deformation": 0.01}
        (sentence,) = failing_sentences(Stub(cases_of({"method": "mss-nfd", "status": "refused"}, other)))
        self.assertIn("in 1 of 1 cases (compression; mildest: compression", sentence)

    def test_a_printed_figure_without_ours_is_not_met(self):
        rows = [
            {"method": "mss-cf", "nu": nu, "printed_text": printed, "printed": 5.0, "ours": ours, "notes": [],
             "difference": None if ours is None or not printed else ours - 5}
            for nu, printed, ours in (("0", "5.00", 5.1), ("0.25", "5.00", 5.3), ("0.4", "5.00", None), ("0.3", "", 7))
        ]
        document = {"table": "5.1", "quantity": "volume", "labels": ["nu", "method"], "unit": "%", "format": "{:.3f}",
                    "rows": rows}
        unmet = {**document, "rows": [rows[2]]}
        (sentence,) = against_print(types.SimpleNamespace(tables={"5.1": unmet}))
        self.assertIn("meets 0 of 1 figures", sentence)
        self.assertNotIn("Furthest", sentence)
        torque = {"method": "mss-cf", "nu": "0.3", "printed_text": "10", "printed": 10.0, "ours": 9.0}
        torque |= {"difference": -1.0, "notes": ["a. b."]}
        torques = {**document, "table": "5.4", "unit": "N m", "format": "{:.0f}", "rows": [torque]}
        (sentence,) = against_print(types.SimpleNamespace(tables={"5.1": document, "5.4": torques}))
        self.assertIn("<b>mss-cf</b> meets 1 of 4 figures", sentence)
        self.assertIn(
            "torque (of 1 nothing usable came out). Furthest: table 5.1, nu 0.25: printed 5.00, ours 5.300, in %; "
            "table 5.4, nu 0.3: printed 10, ours 9, in N m. Deviations",
            sentence,
        )

    def test_medians_are_of_judged_usable_cases(self):
        reference = fem("hencky", "q1-sri")
        cases = cases_of(
            {"plate_force": 1.1}, {"method": "mss-nfd", "plate_force": 1.3},
            {"method": "mss-fd", "plate_force": 1.5, "status": "wrinkled"}, reference,
        )
        springs = cases[cases.kind == "springs"]
        text, style = _force(Stub(cases), springs)
        self.assertTrue(text.startswith("20 % <"), text)
        self.assertIn("2 of 3", text)
        self.assertEqual(style, "")
        self.assertEqual(_force(Stub(cases), springs[springs.status != "ok"])[1], "failed")

    def test_sizes_of_differences(self):
        row = {"difference": -0.5, "printed": 10.0}
        self.assertAlmostEqual(relative_size({"unit": "%"}, row), 0.25)
        self.assertAlmostEqual(relative_size({"unit": "N"}, row), 0.5)
        self.assertIsNone(relative_size({"unit": "N"}, {"difference": None}))


if __name__ == "__main__":
    unittest.main()
