"""The page's section of dynamics, from the whole table of dynamics."""

import json
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent)]
import page_text  # noqa: E402
from program import springcheck  # noqa: E402


class Table(unittest.TestCase):
    def test_the_table_dynamics_has_its_figure_and_rows(self):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        springcheck("table", "dynamics", "--out", folder / "dynamics.h5")
        springcheck("report", folder / "dynamics.h5", "--out", folder)
        section = page_text.section((folder / "index.html").read_text(encoding="utf-8"), "through-time")
        document = json.loads((folder / "tables" / "dynamics.json").read_text(encoding="utf-8"))
        rows = page_text.rows(section, "dynamics")
        self.assertEqual(len(rows), len(document["rows"]))
        self.assertIn("protocols", page_text.figures(section))
        self.assertIn("history_torsion", page_text.figures(section))
        shown = {(n["value"], n.get("data-case")) for n in page_text.numbers(section)}
        for cells, row in zip(rows, document["rows"]):
            for key, case in zip(("static", "dynamic", "raw"), row["cases"]):
                if row[key] is not None:
                    self.assertIn((repr(row[key]), case), shown)
        unstable = rows[[row["static"] for row in document["rows"]].index(None)]
        self.assertIn("no equilibrium", unstable)
        self.assertIn("diverged", unstable)
        self.assertNotIn('id="table-solvers"', section)  # each case once


if __name__ == "__main__":
    unittest.main()
