"""A whole `springcheck reproduce`, killed amid each of its later stages; and every command that its
page, the README and the docs print works on the file that it makes."""

import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from html import unescape
from pathlib import Path

ROOT = Path(__file__).parents[2]
REPORTS = ROOT / "reports"
sys.path[:0] = [str(Path(__file__).parent), str(ROOT / "tests" / "docs"), str(REPORTS)]
sys.path.append(str(REPORTS / "springcheck_report"))
import browser  # noqa: E402
import springcheck_results  # noqa: E402
import study as study_module  # noqa: E402
from explorer import explorer_data  # noqa: E402
from pages import all_pages, parts  # noqa: E402
from program import same_figures, springcheck  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from snippets_test import Reader  # noqa: E402

_STAGES = ("quick chart of shearing", "map of failures", "page")  # in each of which it is killed once
_AMID = 4  # [s] after a stage began
_LONGEST_SILENCE = 12  # [s]: a line every ten, and what a busy machine adds
_LONG_COMMANDS = ("stability", "chart")  # take many minutes: started and killed
# Gates that name less than it takes to choose one of the cases of reproduce, and are told so.
_UNSURE_GATES = {"docs/how-to/gates.md": 1, "docs/tutorial/gate-in-ci.md": 2}


def reproduce(folder, killed_in=None):
    """Lines on stderr, with the seconds at which they came; killed amid the stage of that name."""
    command = [os.environ["SPRINGCHECK"], "reproduce", "--out", str(folder)]
    lines, start = [], time.monotonic()
    with subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True
    ) as program:
        killer = threading.Timer(_AMID, os.killpg, (program.pid, signal.SIGKILL))  # with what it started
        for line in program.stderr:
            lines.append((time.monotonic() - start, line.strip()))
            if killed_in and re.search(rf"stage \d of \d, {killed_in}", line):
                killer.start()
    return program.returncode, lines


def column_of(packed):
    """Values of a column of the explorer."""
    if "codes" not in packed:
        return packed["values"]
    return [None if code < 0 else packed["values"][code] for code in packed["codes"]]


def said_in(lines):
    return "\n".join(line for _, line in lines)


class WholeReproduce(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.begun, cls.had_page = [], []
        for stage in _STAGES:
            cls.begun.append(reproduce(cls.folder, stage))
            cls.had_page.append((cls.folder / "index.html").exists())
        cls.returned, cls.lines = reproduce(cls.folder)
        cls.file = cls.folder / "results.h5"
        cls.page = (cls.folder / "index.html").read_text(encoding="utf-8")

    def test_killed_amid_a_stage_it_goes_on_from_there(self):
        self.assertEqual(self.returned, 0, said_in(self.lines))
        for (returned, lines), stage in zip(self.begun, _STAGES):
            self.assertEqual(returned, -signal.SIGKILL, said_in(lines))
        self.assertEqual(self.had_page, [False] * len(_STAGES))
        for _, lines in [*self.begun[1:], (0, self.lines)]:
            said = said_in(lines)
            self.assertRegex(said, r"stage 1 of 7, tables, 0 cases")
            self.assertRegex(said, r"stage 2 of 7, sweeps, 0 cases")

    def test_no_silence_is_long(self):
        for lines in [*(lines for _, lines in self.begun), self.lines]:
            times = [0] + [seconds for seconds, _ in lines]
            self.assertLess(max(b - a for a, b in zip(times, times[1:])), _LONGEST_SILENCE, said_in(lines))

    def test_file_summary_page_and_log_count_the_same_cases(self):
        exported = springcheck("export", self.file, "--out", self.folder / "all.csv")
        count = re.search(r"(\d+) cases", exported.stdout)[1]
        self.assertGreater(int(count), 1000)
        for text in ((self.folder / "summary.md").read_text(encoding="utf-8"), self.page):
            self.assertRegex(text, rf"\b{count} cases\b")
        self.assertIn(f"{self.file} has {count} cases\n", said_in(self.lines))

    def test_the_gates_of_the_thesis_pass(self):
        gates = springcheck("gate", "thesis", self.file)
        self.assertIn("29 pass, 0 fall short, 0 without a case", gates.stdout)

    def test_the_thesis_tables_fit_a_small_screen(self):
        driver = browser.chromium(webgl=False)
        self.addCleanup(driver.quit)
        size = {"width": 1300, "height": 900, "deviceScaleFactor": 1, "mobile": False}
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
        driver.get((self.folder / "index.html").as_uri())
        for name in ("5.1", "5.2", "5.3", "5.4", "deviation"):
            frame = driver.find_element(By.CSS_SELECTOR, f"[id='table-{name}']").find_element(By.XPATH, "..")
            widths = [int(frame.get_property(name)) for name in ("scrollWidth", "clientWidth")]
            self.assertLessEqual(*widths, name)
            self.assertGreater(widths[1], 900)

    def test_the_pages_long_commands_add_to_the_file(self):
        """As they stand on the page; and killed they leave a file that is as good as before."""
        commands = [unescape(text) for text in re.findall(r"<code>(springcheck [^<]* --out [^<]*)</code>", self.page)]
        self.assertEqual({shlex.split(command)[1] for command in commands}, set(_LONG_COMMANDS), commands)
        self.assertEqual(len(commands), 4, commands)  # three charts, one map
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(shutil.copy(self.file, folder))
            for command in commands:
                with self.subTest(command):
                    self.start_and_kill(shlex.split(command), copy)
            self.assertIn("29 pass", springcheck("gate", "thesis", copy).stdout)

    def start_and_kill(self, words, file):
        before = file.stat().st_size
        command = [os.environ["SPRINGCHECK"], *words[1:]]
        with open(file.with_suffix(".txt"), "w+", encoding="utf-8") as said:
            running = subprocess.Popen(command, cwd=file.parent, stdout=said, stderr=said)
            end = time.monotonic() + 300
            while running.poll() is None and file.stat().st_size <= before and time.monotonic() < end:
                time.sleep(0.2)
            still_runs = running.poll() is None
            running.kill()
            running.wait()
            said.seek(0)
            self.assertTrue(still_runs, said.read())
        self.assertGreater(file.stat().st_size, before)

    def test_commands_of_cases_compute_them_again(self):
        """One of each scene and method, that of fewest cells: the same key. Or the same figures, where `run`
        takes a reference that the case has not, or solves it otherwise than the case did."""
        study = study_module.read(self.file, self.folder)
        columns = explorer_data(study)["columns"]
        commands = dict(zip(*(column_of(columns[name]) for name in ("key", "command"))))
        cases = study.cases[study.cases.kind != "measured"]
        chosen = cases.sort_values(["cells.x", "deformation"]).groupby(["scene", "method"], sort=True).head(1)
        self.assertGreater(len(chosen), 60)
        with tempfile.TemporaryDirectory() as folder:
            again = Path(folder) / "again.h5"
            for key, case in chosen.iterrows():
                command = commands[key]
                ended = springcheck(*shlex.split(command)[1:], "--out", again, check=False)
                self.assertIn(ended.returncode, (0, 3), f"{command}\n{ended.stderr}")
                made = springcheck_results.read(again).cases
                if key not in made.index:
                    stored = study.results.cases.loc[key]
                    self.assertTrue(same_figures(made, stored).any(), command)
                    if stored.reference:
                        (off,) = abs(made.deviation_l2_relative.dropna() / stored.deviation_l2_relative - 1)
                        self.assertLess(off, 1e-6, command)
                again.unlink()

    def test_commands_of_the_docs_work_on_the_file(self):
        """Each page that names results.h5 is worked through beside the file that reproduce made."""
        pages = [page for page in all_pages() if re.search(r"^springcheck .*\bresults\.h5", page.read_text(), re.M)]
        self.assertGreater(len(pages), 4)
        for page in pages:
            name = str(page.relative_to(ROOT))
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                reader = Reader(page, Path(folder))
                shutil.copy(self.file, folder)
                unsure = 0
                for part in parts(page):
                    if {"slow", "run by"} & set(part.marks):
                        continue
                    if getattr(part, "file", ""):
                        reader.save(part)
                    elif getattr(part, "language", "") == "sh":
                        try:
                            reader.run(part)
                        except AssertionError as error:
                            if "they differ in" not in str(error):
                                raise
                            unsure += 1
                self.assertEqual(unsure, _UNSURE_GATES.get(name, 0))


if __name__ == "__main__":
    unittest.main()
