"""speed_test.py and atlas_test.py, of the tables that the program makes now."""

import json
import sys
import unittest
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent)]
import atlas_test  # noqa: E402
import speed_test  # noqa: E402
from program import springcheck  # noqa: E402


class MeasuredSpeed(speed_test.Speed):
    @classmethod
    def table(cls, name):
        return springcheck("table", name, "--format", "json", "--threads", speed_test.THREADS).stdout

    def test_what_was_recorded_has_the_columns_of_today(self):
        for name in ("performance", "modes"):
            now = json.loads((self.folder / "tables" / f"{name}.json").read_text(encoding="utf-8"))
            self.assertEqual(json.loads(speed_test.Speed.table(name))["columns"], now["columns"])


class ComputedTheory(atlas_test.Page):
    @classmethod
    def table(cls, name):
        return springcheck("table", name, "--format", "json").stdout

    def test_what_was_recorded_has_the_columns_and_rows_of_today(self):
        now, recorded = (json.loads(table("lattice-stability")) for table in (self.table, atlas_test.Page.table))
        self.assertEqual(recorded["columns"], now["columns"])
        self.assertEqual(len(recorded["rows"]), len(now["rows"]))


if __name__ == "__main__":
    unittest.main()
