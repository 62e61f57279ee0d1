"""The page's section of living tissue, from a file with the tables' cases."""

import shutil
import sys
import tempfile
import unittest
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent)]
import page_text  # noqa: E402
from program import springcheck  # noqa: E402

TABLES = {"tissue": 81, "tissue-relaxation": 24, "tissue-oscillation": 12}


class Tissue(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.file = cls.folder / "tissue.h5"
        for name in TABLES:
            springcheck("table", name, "--out", cls.file)
        springcheck("report", cls.file, "--out", cls.folder / "page")
        page = (cls.folder / "page" / "index.html").read_text(encoding="utf-8")
        cls.section = page_text.section(page, "tissue")

    def test_every_table_is_there_with_a_figure(self):
        names = ["tissue_shear", "tissue_relaxation", "tissue_moduli"]
        self.assertEqual(page_text.figures(self.section), names)
        for name, count in TABLES.items():
            self.assertEqual(len(page_text.rows(self.section, name)), min(count, 30), name)

    def test_rows_belong_to_their_cases(self):
        for name in TABLES:
            for row in page_text.rows(self.section, name):
                self.assertRegex(row[-1], "^[0-9a-f]{8}$", name)


if __name__ == "__main__":
    unittest.main()
