"""Ctrl-C: the program says what is kept and how to go on, leaves no lock, and ends by the
signal."""

import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.environ["SPRINGCHECK"]


def catches(program, number):
    """Whether it does something itself where the signal comes."""
    status = pathlib.Path(f"/proc/{program.pid}/status").read_text(encoding="utf-8")
    caught = next(line for line in status.splitlines() if line.startswith("SigCgt:"))
    return bool(int(caught.split()[1], 16) >> (number - 1) & 1)


class Interruption(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *words, before=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)):
        return subprocess.Popen([PROGRAM, *words], cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, preexec_fn=before,
                                env=os.environ | {"TMPDIR": str(self.folder)})

    def interrupted(self, *words, when, by=signal.SIGINT):
        """What a command says on stderr when it is ended once `when` is true."""
        program = self.start(*words)
        self.wait_until_it_catches(program, by)
        end = time.monotonic() + 120
        while not when() and program.poll() is None and time.monotonic() < end:
            time.sleep(0.01)
        program.send_signal(by)
        _, errors = program.communicate(timeout=60)
        self.assertEqual(program.returncode, -by, errors)
        left = [path.name for path in self.folder.iterdir()]
        self.assertFalse([name for name in left if name.endswith(".lock")], left)
        self.assertFalse([name for name in left if name.startswith("springcheck-")], left)
        return errors

    def wait_until_it_catches(self, program, number):
        end = time.monotonic() + 120
        while program.poll() is None and not catches(program, number):
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)

    def after(self, seconds):
        """So long after it was first asked."""
        ends = []

        def is_after():
            ends.append(time.monotonic() + seconds)
            return time.monotonic() > ends[0]
        return is_after

    def there(self, name):
        return lambda: (self.folder / name).exists()

    def test_a_sweep_goes_on(self):
        sweep = ("sweep", "refinement", "--out", "r.h5", "--jobs", "1")
        file = self.folder / "r.h5"
        for by in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            before = file.stat().st_size if file.exists() else 0
            errors = self.interrupted(
                *sweep, by=by,
                when=lambda: file.exists() and file.stat().st_size > max(before, 200_000))
            self.assertIn("interrupted. What was complete is in r.h5. The same command goes on "
                          "from there.", errors)
        told = subprocess.run([PROGRAM, *sweep, "--dry-run"], cwd=self.folder, text=True,
                              capture_output=True, check=True).stdout
        self.assertRegex(told, "refinement: 18 cases, 1[0-7] of them to compute")

    def test_what_is_kept_nowhere_is_said_so(self):
        errors = self.interrupted("run", "compression", "--cells", "60,60,60", "--method",
                                  "mss-cf", when=self.after(0.5))
        self.assertIn("Nothing is kept: --out FILE keeps what is computed.", errors)
        errors = self.interrupted("run", "compression", "--cells", "60,60,60", "--solver",
                                  "verlet", "--method", "mss-cf", "--checkpoint", "c.h5",
                                  when=self.after(0.5))
        self.assertIn("Nothing was kept yet.", errors)
        errors = self.interrupted("sweep", "refinement", "--out", "r.h5", "--recompute",
                                  when=self.after(0.5))
        self.assertIn("Without --recompute and --only-failed", errors)

    def test_a_report_ends_with_its_program(self):
        subprocess.run([PROGRAM, "run", "compression", "--cells", "2,2,2", "--out", "a.h5"],
                       cwd=self.folder, check=True, capture_output=True)
        errors = self.interrupted("report", "a.h5", "--out", "page",
                                  when=self.there("page/data/unfinished"))
        self.assertIn("an earlier report is as it was", errors)
        self.assertFalse((self.folder / "page/index.html").exists())
        subprocess.run([PROGRAM, "report", "a.h5", "--out", "page"], cwd=self.folder, check=True,
                       capture_output=True)

    def test_an_ignored_signal_stays_so(self):
        program = self.start("run", "compression", "--cells", "16,16,16",
                             before=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
        time.sleep(1)
        program.send_signal(signal.SIGINT)
        program.communicate(timeout=120)
        self.assertEqual(program.returncode, 0)

    def test_a_second_signal_ends_it_at_once(self):
        """Though it cannot say anything: nobody reads stderr, which is full."""
        reading, writing = os.pipe()
        os.set_blocking(writing, False)
        try:
            while True:
                os.write(writing, b"x" * 4096)
        except BlockingIOError:
            os.set_blocking(writing, True)
        program = subprocess.Popen([PROGRAM, "run", "compression", "--cells", "60,60,60"],
                                   stdout=subprocess.DEVNULL, stderr=writing,
                                   preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        self.wait_until_it_catches(program, signal.SIGINT)
        time.sleep(2)  # it has something to say only once the command has begun
        program.send_signal(signal.SIGINT)
        time.sleep(0.5)
        self.assertIsNone(program.poll())
        program.send_signal(signal.SIGTERM)
        self.assertEqual(program.wait(timeout=10), -signal.SIGTERM)
        os.close(reading)
        os.close(writing)


if __name__ == "__main__":
    unittest.main()
