"""Every column and group of a result file is one that `springcheck list` describes."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import h5py

from pages import ROOT

PROGRAM = os.environ.get("SPRINGCHECK", str(ROOT / "build/release/springcheck"))


def run(*arguments, folder):
    return subprocess.run([PROGRAM, *arguments], cwd=folder, capture_output=True, text=True,
                          check=True).stdout


class ResultFile(unittest.TestCase):
    def test_what_a_file_holds_is_described(self):
        lists = json.loads(run("list", "--json", folder="."))
        with tempfile.TemporaryDirectory() as folder:
            small = ["--cells", "3,3,3", "--out", "all.h5"]
            run("sweep", "accuracy", "--out", "all.h5", folder=folder)
            run("run", "shearing", "--method", "mss-cf", "--solver", "verlet", "--duration",
                ".01", "--history", "5", *small, folder=folder)
            run("run", "shearing", "--method", "fem-hooke", "--linear-solver", "multigrid",
                *small, folder=folder)
            run("stability", "compression", "--method", "mss-cf", "--over",
                "deformation=5%,10%", *small, folder=folder)
            with h5py.File(pathlib.Path(folder) / "all.h5") as file:
                columns, groups = set(file["cases"]), set(file)
        described = {*lists["settings"], *lists["measures"], *lists["columns"]}
        self.assertEqual({name for name in columns if name not in described
                          and name.replace("_", "-") not in described}, set())
        told = {name.split("/")[1] for name in lists["result-file"]}
        self.assertEqual(groups - told, set())
        self.assertLessEqual({"cases", "provenance", "meshes", "fields", "maps"}, groups)
        # Nothing is described that no file has: those of measured results are in
        # how-to/own-results, charts' in the chart's tests.
        self.assertEqual(set(lists["columns"]) - columns, {"source", "displacements", "forces"})


if __name__ == "__main__":
    unittest.main()
