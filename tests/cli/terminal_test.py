"""What a terminal shows: lines as wide as it is, colours, the same numbers in any locale."""

import fcntl
import os
import pty
import re
import struct
import subprocess
import tempfile
import termios
import time
import unittest

PROGRAM = os.environ["SPRINGCHECK"]
RUN = ("run", "compression", "--cells", "2,2,2", "--method", "mss-cf,mss-baudet", "--nu", "0.45")


def shown(*words, width=60, **variables):
    """The output of a command on a terminal that is so wide."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 40, width, 0, 0))
    without = {name: text for name, text in os.environ.items()
               if name not in ("COLUMNS", "NO_COLOR")}
    program = subprocess.Popen([PROGRAM, *words], stdin=theirs, stdout=theirs,
                               stderr=subprocess.DEVNULL,
                               env=without | {"TERM": "xterm"} | variables)
    os.close(theirs)
    output = b""
    while True:
        try:
            part = os.read(ours, 65536)
        except OSError:  # it has ended
            break
        if not part:
            break
        output += part
    os.close(ours)
    program.wait()
    return output.decode().replace("\r\n", "\n")


def piped(*words, **variables):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True,
                          env=os.environ | variables).stdout


def without_times(text):
    """Of a run's CSV, where they stand before notes and case, and of its JSON."""
    return re.sub(r"[\d.e-]+,,[0-9a-f]{64}$|\"\w+_s\": .*", "", text, flags=re.M)


class Terminal(unittest.TestCase):
    def is_within(self, text, width):
        for line in text.splitlines():
            if " " in line.strip():
                self.assertLessEqual(len(line), width, line)

    def test_sixty_columns(self):
        for words in (RUN, ("list",), ("list", "measures"), ("help",), ("help", "run"),
                      ("table", "--list"), ("mesh", "kidney", "--quality")):
            text = shown(*words, NO_COLOR="1")
            self.assertGreater(len(text), 200)
            self.is_within(text, 60)

    def test_wide_terminals_and_pipes_show_a_line_for_each_method(self):
        self.assertRegex(shown(*RUN, width=200, NO_COLOR="1"), r"(?m)^mss-baudet +\w+ +-")
        self.assertRegex(piped(*RUN), r"(?m)^mss-baudet +\w+ +-")
        self.assertRegex(shown(*RUN, NO_COLOR="1"), r"(?m)^method +mss-cf +mss-baudet")

    def test_statuses_have_colours_on_terminals_alone(self):
        self.assertIn("\x1b[32mok\x1b[0m", shown(*RUN, width=200))
        for plain in (shown(*RUN, NO_COLOR="1"), shown(*RUN, TERM="dumb"), piped(*RUN)):
            self.assertIn("ok", plain)
            self.assertNotIn("\x1b", plain)
        self.assertIn("\x1b", shown(*RUN, NO_COLOR=""))  # as no-color.org has it
        self.assertIn("\x1b[31minverted\x1b[0m",
                      shown("run", "compression", "--cells", "2,2,2", "--method", "mss-cf",
                            "--deformation", "90%", width=200))

    def test_verdicts_have_colours(self):
        with tempfile.TemporaryDirectory() as folder:
            results, gates = folder + "/r.h5", folder + "/g.toml"
            subprocess.run([PROGRAM, *RUN, "--out", results], check=True, capture_output=True)
            with open(gates, "w", encoding="utf-8") as file:
                for name, method, most in (("met", "mss-cf", 1), ("failed", "mss-cf", 1e-9),
                                           ("none", "mss-fd", 1)):
                    file.write(f'[[gate]]\nname = "{name}"\nwhere = {{method = "{method}"}}\n'
                               f'measure = "volume_error"\nat_most = {most}\nreason = "it is a test"\n')
            self.is_within(shown("gate", gates, results, NO_COLOR="1"), 60)
            text = shown("gate", gates, results, width=200)
            for verdict in ("\x1b[32mpass", "\x1b[31mfalls short", "\x1b[33mno case"):
                self.assertIn(verdict, text)

    def test_a_decimal_comma_changes_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", folder + "/de_DE.UTF-8"],
                           check=True, capture_output=True)
            comma = {"LC_ALL": "de_DE.UTF-8", "LOCPATH": folder}
            self.assertEqual(subprocess.run(["locale", "decimal_point"], capture_output=True,
                                            env=os.environ | comma, text=True).stdout, ",\n")
            for words in ((*RUN, "--format", "csv"), (*RUN, "--json"), ("help", "run"),
                          ("list", "settings", "--json"), ("mesh", "kidney", "--quality")):
                texts = [without_times(piped(*words, **variables))
                         for variables in ({"LC_ALL": "C"}, comma)]
                self.assertEqual(*texts)


class StartUp(unittest.TestCase):
    def test_what_is_told_loads_no_finite_elements(self):
        """The program that tells help and lists loads neither deal.II nor gmsh."""
        libraries = subprocess.run(["ldd", PROGRAM], capture_output=True, text=True,
                                   check=True).stdout
        self.assertNotIn("deal", libraries)
        self.assertNotIn("gmsh", libraries)
        self.assertLess(len(libraries.splitlines()), 40)


if __name__ == "__main__":
    unittest.main()
