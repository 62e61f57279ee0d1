"""The page's sections of tables without cases: speed and natural frequencies, from what the
program once measured. measured_tables_test.py has it measure again."""

import json
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent)]
import page_text  # noqa: E402
from program import same_files, springcheck  # noqa: E402

THREADS = 2


class Speed(unittest.TestCase):
    @classmethod
    def table(cls, name):
        """As `springcheck table NAME --format json --threads 2` wrote it; of the performance
        two bodies a scene."""
        return (Path(__file__).parent / "recorded" / f"{name}.json").read_text(encoding="utf-8")

    @classmethod
    def setUpClass(cls):
        """As `reproduce` leaves them: tables beside the result file."""
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        (cls.folder / "tables").mkdir()
        for name in ("performance", "modes"):
            (cls.folder / "tables" / f"{name}.json").write_text(cls.table(name), encoding="utf-8")
        cls.document = json.loads((cls.folder / "tables" / "performance.json").read_text())
        cls.file = cls.folder / "results.h5"
        scene = "run compression --method mss-cf,fem-hencky --nu 0.25 --deformation 5% --out"
        springcheck(*scene.split(), cls.file)
        cls.report = cls.folder / "elsewhere"
        springcheck("report", cls.file, "--out", cls.report)
        cls.page = (cls.report / "index.html").read_text(encoding="utf-8")
        cls.section = page_text.section(cls.page, "speed")

    def test_tables_without_cases_go_with_the_result_file(self):
        for name in ("performance", "modes"):
            theirs = self.folder / "tables" / f"{name}.json"
            self.assertEqual((self.report / "tables" / theirs.name).read_text(), theirs.read_text())
        springcheck("report", self.file, "--out", self.folder)  # in their own folder
        same_files(self, self.report, self.folder)
        (self.folder / "other").mkdir()
        other = self.folder / "other" / "results.h5"
        shutil.copyfile(self.file, other)
        earlier = self.folder / "earlier"
        shutil.copytree(self.report, earlier)
        springcheck("report", other, "--out", earlier)
        self.assertFalse((earlier / "tables" / "performance.json").exists())

    def test_the_machine_the_compiler_and_the_instruction_set_are_named(self):
        self.assertRegex(
            self.section,
            r"Measured on .+, clock .+, \w+ \w+, OpenBLAS [\d.]+ \w+, \w+-[\d.]+ -O\d",
        )

    def test_a_machine_with_other_work_is_said_to_have_it(self):
        least = min(row["user_over_real"] for row in self.document["rows"] if row["threads"] == 1)
        self.assertEqual("had other work" in self.section, least < 0.9)

    def test_both_printed_times_stand_beside_ours(self):
        rows = page_text.rows(self.section, "printed-times")
        self.assertEqual(len(rows), 2 * THREADS)
        self.assertEqual({row[3] for row in rows}, {"5.579", "74.149"})
        self.assertEqual({row[2] for row in rows}, {"10,000", "300,000"})
        printed = [row for row in self.document["rows"] if row["printed_seconds"]]
        for cells, row in zip(rows, printed):
            self.assertAlmostEqual(float(cells[5]), row["seconds_as_printed"], delta=0.006 * float(cells[5]))

    def test_numbers_are_those_of_the_table(self):
        own = {repr(value) for row in self.document["rows"] for value in row.values() if isinstance(value, float)}
        numbers = [n for n in page_text.numbers(self.section) if n.get("data-table") == "performance"]
        ratios = [n for n in numbers if n["value"] not in own]
        self.assertGreater(len(numbers), 10)
        self.assertEqual(len(ratios), 2 * THREADS)  # printed over ours
        self.assertEqual(len(page_text.rows(self.section, "performance")), len(self.document["rows"]))
        self.assertNotIn('class="failed"', self.section)  # a blank is no failure

    def test_figures_of_both_scenes_and_table_5_5(self):
        names = ["speed_time", "speed_occupied", "speed_occupied_by_threads", "speed_threads"]
        self.assertEqual(page_text.figures(self.section), names)
        self.assertEqual(len(page_text.rows(self.section, "5.5")), 8)
        self.assertEqual(self.page.count('id="table-5.5"'), 1)

    def test_natural_frequencies_have_a_figure(self):
        section = page_text.section(self.page, "modes")
        self.assertEqual(page_text.figures(section), ["modes"])


if __name__ == "__main__":
    unittest.main()
