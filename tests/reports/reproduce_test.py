"""What `springcheck reproduce` makes can be used, and it goes on where it was interrupted."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent)]
import h5py  # noqa: E402
from program import springcheck  # noqa: E402

_LONGEST_SILENCE = 12  # [s]: a line every ten, and what a busy machine adds
_KILLED_AFTER = 10  # [s]: amid the simulations


class Reproduce(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def reproduce(self, killed_after=None):
        """Lines on stderr, with the seconds at which they came."""
        start = time.monotonic()
        command = [os.environ["SPRINGCHECK"], "reproduce", "--quick", "--out", str(self.folder)]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as program:
            lines = []
            for line in program.stderr:
                lines.append((time.monotonic() - start, line.strip()))
                if killed_after and lines[-1][0] > killed_after:
                    program.kill()
        self.assertEqual(program.returncode == 0, killed_after is None, lines)
        return lines

    def test_a_file_of_another_revision_is_kept_beside(self):
        file = self.folder / "results.h5"
        springcheck("run", "compression", "--cells", "2,2,2", "--out", file)
        with h5py.File(file, "r+") as made:
            made["provenance/revision"][...] = b"0123456789ab"
        theirs = file.read_bytes()
        lines = self.reproduce(_KILLED_AFTER)
        self.assertIn("results-0123456789ab.h5", lines[0][1])
        self.assertEqual((self.folder / "results-0123456789ab.h5").read_bytes(), theirs)
        self.assertGreater(self.cases_to_compute(lines), 0)

    def cases_to_compute(self, lines):
        text = "\n".join(line for _, line in lines)
        return int(re.search(r"stage 1 of 2, tables, (\d+) cases; about \d+ s left in all", text)[1])

    def test_a_killed_run_goes_on_and_its_file_passes_the_gates(self):
        all_cases = self.cases_to_compute(self.reproduce(_KILLED_AFTER))
        lines = self.reproduce()
        self.assertLess(self.cases_to_compute(lines), all_cases)
        times = [0] + [seconds for seconds, _ in lines]
        self.assertLess(max(b - a for a, b in zip(times, times[1:])), _LONGEST_SILENCE, lines)
        self.assertTrue(any(re.search(r"simulations \d+/\d+, about \d+ s left", line) for _, line in lines), lines)

        gates = springcheck("gate", "thesis", self.folder / "results.h5")
        self.assertIn("29 pass, 0 fall short, 0 without a case", gates.stdout)

        exported = springcheck("export", self.folder / "results.h5", "--out", self.folder / "all.csv")
        count = re.search(r"(\d+) cases", exported.stdout)[1]
        self.assertEqual(count, str(all_cases))
        for text in ((self.folder / "summary.md").read_text(), (self.folder / "index.html").read_text()):
            self.assertRegex(text, rf"\b{count} cases\b")
        self.assertTrue(any(line.endswith(f"results.h5 has {count} cases") for _, line in lines), lines)

        self.assertEqual(self.cases_to_compute(self.reproduce()), 0)


if __name__ == "__main__":
    unittest.main()
