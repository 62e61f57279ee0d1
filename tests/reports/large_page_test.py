"""page_test.py with more views, which a browser without a graphics card draws slowly, and a
page of thousands of cases."""

import shutil
import sys
import tempfile
import unittest
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent)]
import h5py  # noqa: E402
import numpy as np  # noqa: E402
import page_test  # noqa: E402
from program import same_files, springcheck  # noqa: E402


class AllViews(page_test.Page):
    TURNED = ("compression", "shearing", "bending")

    def test_the_report_is_the_same_again(self):
        again = self.folder / "again"
        springcheck("report", self.file, "--out", again)
        same_files(self, self.report, again)


class Large(unittest.TestCase):
    def test_thousands_of_cases(self):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        file = folder / "many.h5"
        springcheck("run", "compression", "--method", "mss-cf,fem-hencky", "--cells", "2,2,2", "--out",
                    file)
        with h5py.File(file, "r+") as made:
            cases = made["cases"]
            for name, column in list(cases.items()):
                kind = column.dtype  # with its encoding
                values = np.repeat(column[()], 2500, axis=0)
                if name == "key":
                    values = np.array([f"{i:064d}" for i in range(len(values))]).astype(kind)
                if name == "nu":
                    values = np.linspace(0, 0.49, len(values))
                del cases[name]
                cases.create_dataset(name, data=values.astype(kind), dtype=kind)
        springcheck("report", file, "--out", folder / "report")
        page = (folder / "report" / "index.html").read_text(encoding="utf-8")
        self.assertRegex(page, r"many.h5: 5000 cases, the newest of")
        self.assertLess(len(page), 15e6)


if __name__ == "__main__":
    unittest.main()
