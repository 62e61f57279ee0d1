"""Reports of small files, of broken ones and of none. SPRINGCHECK names the program."""

import contextlib
import io
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent)]
import numpy as np  # noqa: E402
import page_text  # noqa: E402
from program import slow, springcheck  # noqa: E402


class SmallFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """A file of one case, and its report."""
        one = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, one)
        cls.one, cls.report_of_one = one / "one.h5", one / "report"
        springcheck("run", "compression", "--method", "mss-cf", "--cells", "2,2,2", "--nu", "0.25",
                    "--out", cls.one)
        springcheck("report", cls.one, "--out", cls.report_of_one)

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def page_of(self, file):
        mine = self.folder / "report" / "figures" / "mine.svg"
        mine.parent.mkdir(parents=True, exist_ok=True)
        mine.write_text("mine")
        said = springcheck("report", file, "--out", self.folder / "report").stderr
        self.assertNotIn("Warning", said)  # of Python to its programmers, not to users
        self.assertEqual(mine.read_text(), "mine")  # files of others stay
        return (self.folder / "report" / "index.html").read_text(encoding="utf-8")

    def test_an_empty_file_says_what_to_run(self):
        import h5py

        file = self.folder / "empty.h5"
        with h5py.File(file, "w") as made:
            made.attrs["layout"] = 2
            for name in ("cases", "provenance", "meshes", "fields"):
                made.create_group(name)
        page = self.page_of(file)
        self.assertIn("springcheck run compression --out", page)
        self.assertNotIn("Plotly", page)

    def test_one_case(self):
        page = (self.report_of_one / "index.html").read_text(encoding="utf-8")
        self.assertIn("1 case: 1 ok", page)
        for name in ("chart", "atlas", "tissue", "through-time", "speed", "modes"):
            self.assertIsNone(page_text.section(page, name), name)

    @slow
    def test_failed_and_refused_cases_alone(self):
        file = self.folder / "failed.h5"
        springcheck("run", "compression", "--method", "mss-nfd,mss-lloyd", "--cells", "4,4,4", "--nu",
                    "0", "--deformation", "20%", "--out", file, check=False)
        page = self.page_of(file)
        self.assertIn("no equilibrium", page)
        self.assertIn("refused (its springs need tetrahedra", page)
        self.assertIn('id="failures"', page)

    @slow
    def test_a_mesh_of_a_file_and_other_tests(self):
        file = self.folder / "kidney.h5"
        springcheck("run", "kidney", "--cells", "4,4,4", "--out", file)
        springcheck("run", "traction", "--cells", "2,2,2", "--method", "mss-cf", "--out", file)
        page = self.page_of(file)
        self.assertIn('data-test="compression"', page)
        self.assertIn('data-test="traction"', page)

    def test_what_an_earlier_report_made_goes_and_what_others_made_stays(self):
        shutil.copytree(self.report_of_one, self.folder / "report")
        made = set((self.folder / "report" / "3d").iterdir())
        springcheck("run", "shearing", "--method", "mss-cf", "--cells", "2,2,2", "--out",
                    self.folder / "two.h5")
        self.page_of(self.folder / "two.h5")
        left = made & set((self.folder / "report" / "3d").iterdir())
        self.assertEqual({path.name for path in left}, {"show.py", "cases.xdmf"})
        (self.folder / "report" / "index.html").write_text("<p>my page</p>")
        ended = springcheck("report", self.one, "--out", self.folder / "report", check=False)
        self.assertEqual(ended.returncode, 2)
        self.assertEqual((self.folder / "report" / "index.html").read_text(), "<p>my page</p>")

    @slow
    def test_broken_fields_are_left_out(self):
        import h5py

        file = self.folder / "broken.h5"
        springcheck("run", "compression", "--method", "mss-cf,mss-fd,fem-hencky", "--cells", "2,2,2",
                    "--nu", "0.25", "--out", file)
        with h5py.File(file, "r+") as made:
            first, second, _ = made["fields"]
            made["fields"][first]["displacement"][0, 0] = np.nan
            del made["fields"][second]["cell_volume_ratio"]
            made["cases"]["cell_volume_ratio_min"][...] = np.nan
        self.assertIn('id="figure-bodies_compression"', self.page_of(file))

    @slow
    def test_a_page_stays_whole_when_the_next_is_ended(self):
        report = self.folder / "report"
        shutil.copytree(self.report_of_one, report)
        page = (report / "index.html").read_text(encoding="utf-8")
        before = sorted(report.rglob("*"))
        unfinished = report / "data" / "unfinished"
        for end in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            unfinished.mkdir()  # left by one that could not clean up
            (unfinished / "old").touch()
            started = subprocess.Popen(
                [os.environ["SPRINGCHECK"], "report", self.one, "--out", report],
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            while started.poll() is None and not (unfinished / "figures").exists():
                time.sleep(0.01)
            started.send_signal(end)
            _, errors = started.communicate()
            if started.returncode != 0:  # else it was done already
                self.assertEqual(started.returncode, -end)
                self.assertNotIn("Traceback", errors)
                self.assertEqual(sorted(report.rglob("*")), before)
            self.assertEqual((report / "index.html").read_text(encoding="utf-8"), page)

    def test_missing_packages_are_named(self):
        import runpy

        main = runpy.run_path(str(Path(__file__).parents[2] / "reports/springcheck_report/__main__.py"))
        main["PACKAGES"]["no_such_module"] = "python3-no-such"
        self.assertEqual(main["missing_packages"](), ["python3-no-such"])
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors):
            self.assertEqual(main["main"](["a.h5", "b"]), 1)
        self.assertIn("sudo apt-get install python3-no-such", errors.getvalue())

    def test_bad_input_is_named_and_nothing_is_written(self):
        text = self.folder / "notes.h5"
        text.write_text("notes")
        for file in (text, self.folder / "none.h5"):
            ended = springcheck("report", file, "--out", self.folder / "out", check=False)
            self.assertEqual(ended.returncode, 2)
            self.assertIn(str(file), ended.stderr)
            self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
