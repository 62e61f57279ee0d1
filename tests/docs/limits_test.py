"""The limits that docs/explanation/stability.md prints are those of the shipped sweep.

    limits_test.py             the coarsest meshes, computed
    limits_test.py FILE.csv    all meshes, exported from the sweep's result file
"""

import csv
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from pages import ROOT

PROGRAM = os.environ.get("SPRINGCHECK", str(ROOT / "build/release/springcheck"))
SWEEP = ROOT / "comparisons/shipped/sweeps/limits.toml"
PAGE = ROOT / "docs/explanation/stability.md"
EXPORTED = sys.argv.pop(1) if sys.argv[1:] and sys.argv[1].endswith(".csv") else None
MESHES = ("4,4,4", "6,6,6", "8,8,8")
COLUMNS = ("scene", "method", "cells", "nu", "deformation", "definite_up_to_deformation",
           "status", "reason")


def printed():
    """{(test, cells, nu, method): (value, letter)}; a letter is ">" where the path holds."""
    limits = {}
    meshes = nu = test = None
    for line in PAGE.read_text().splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if head := re.fullmatch(r"(compression|torsion|tension) \[.\], ν =", cells[0]):
            test, nu = head[1], [float(value) for value in cells[1:]]
            # The third table is of the scene's column.
            meshes = ("4,4,24",) if min(nu) < 0 else MESHES
        elif not line.startswith("|"):
            test = None
        elif test and not line.startswith("| ---"):
            for value, cell in zip(nu, cells[1:], strict=True):
                found = re.findall(r"(>)? ?([\d.]+) ?([Dwip])?", cell)
                found = found * len(meshes) if len(found) == 1 else found
                for mesh, (holds, limit, letter) in zip(meshes, found, strict=True):
                    for method in cells[0].split(", "):
                        limits[test, mesh, value, method] = (
                            float(limit), holds or letter or found[-1][2])
    return limits


def computed(file):
    """The same of cases: value in percent or degrees, letter, and how far it was tried."""
    limits = {}
    with open(file, newline="") as lines:
        for case in csv.DictReader(lines):
            # Names of settings have their unit behind them.
            case = {name.split(" [")[0]: value for name, value in case.items()}
            test, status, reason = case["scene"], case["status"], case["reason"]
            unit = math.degrees(1) if test == "torsion" else 100
            tried = unit * float(case["deformation"])
            letter = (">" if status == "ok" else "i" if status == "inverted" else
                      "p" if status == "no_equilibrium" else
                      "D" if "it buckles" in reason else "w")
            limit = tried if letter == ">" else unit * float(
                case["definite_up_to_deformation"])
            mesh = ",".join(case["cells." + along] for along in "xyz")
            limits[test, mesh, float(case["nu"]), case["method"]] = limit, letter, tried
    return limits


def compare(test, limits):
    expected = printed()
    test.assertGreater(len(limits), 100)
    for case, (limit, letter, tried) in limits.items():
        value, printed_letter = expected[case]
        with test.subTest(case=case):
            digit = 1 if case[0] == "torsion" else 0.1
            # The search ends at 1/1024 of what is tried.
            test.assertLessEqual(abs(limit - value), digit / 2 + tried / 1024, (limit, value))
            test.assertEqual(letter, printed_letter)
    return expected


class Limits(unittest.TestCase):
    @unittest.skipUnless(EXPORTED, "no file is given")
    def test_all_meshes(self):
        limits = computed(EXPORTED)
        self.assertEqual(set(limits), set(compare(self, limits)))

    @unittest.skipIf(EXPORTED, "a file is given")
    def test_coarsest_meshes(self):
        text = SWEEP.read_text()
        all_meshes = "[[4, 4, 4], [6, 6, 6], [8, 8, 8]]"
        self.assertEqual(text.count(all_meshes), 1)
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "limits.toml").write_text(text.replace(all_meshes, "[[4, 4, 4]]"))
            run = subprocess.run([PROGRAM, "sweep", "limits.toml", "--out", "limits.h5"],
                                 cwd=folder, capture_output=True, text=True)
            # Paths that end leave their cases without an equilibrium.
            self.assertIn(run.returncode, (0, 3), run.stderr)
            subprocess.run([PROGRAM, "export", "limits.h5", "--out", "limits.csv",
                            "--columns", ",".join(COLUMNS)], cwd=folder, check=True,
                           capture_output=True)
            limits = computed(folder / "limits.csv")
        expected = compare(self, limits)
        coarsest = {case for case in expected if case[1] in ("4,4,4", "4,4,24")}
        self.assertEqual(set(limits), coarsest)


if __name__ == "__main__":
    unittest.main()
