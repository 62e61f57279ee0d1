"""The scripts of `springcheck completion` complete, in bash, zsh and fish themselves."""

import os
import pathlib
import pty
import re
import select
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.environ["SPRINGCHECK"]


def script(shell):
    return subprocess.run([PROGRAM, "completion", shell], capture_output=True, text=True,
                          check=True).stdout


class Completion(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)
        for name in ("mine.toml", "my results.h5"):
            (self.path / name).touch()
        (self.path / "folder").mkdir()

    def bash(self, line):
        """What bash offers at the end of the line."""
        words = line.split(" ")
        quoted = " ".join(f"'{word}'" for word in words)
        (self.path / "script").write_text(
            script("bash") + f"compopt() {{ :; }}\nCOMP_WORDS=({quoted})\n"
            f"COMP_CWORD={len(words) - 1}\n_springcheck\n"
            'printf "%s\\n" "${COMPREPLY[@]}"\n')
        run = subprocess.run(["bash", "script"], cwd=self.path, capture_output=True, text=True,
                             check=True)
        self.assertEqual(run.stderr, "")
        return run.stdout.split("\n")[:-1]

    def fish(self, line):
        (self.path / "script").write_text(script("fish"))
        run = subprocess.run(["fish", "--no-config", "-c", f"source script; complete -C '{line}'"],
                             cwd=self.path, capture_output=True, text=True, check=True)
        self.assertEqual(run.stderr, "")
        return [offer.split("\t")[0] for offer in run.stdout.splitlines()]

    def zsh(self, line):
        """The line after a tab, in an interactive zsh."""
        (self.path / "_springcheck").write_text(script("zsh"))
        pid, terminal = pty.fork()
        if pid == 0:
            os.chdir(self.path)
            os.execvpe("zsh", ["zsh", "-f"], os.environ | {"TERM": "dumb", "COLUMNS": "200"})
        self.addCleanup(os.close, terminal)
        self.answer(terminal, f"PS1='$ '; fpath=({self.path} $fpath); "
                    "autoload -U compinit; compinit -u -D; echo rea''dy\n", "\nready")
        typed = self.answer(terminal, line + "\t", None)
        os.write(terminal, b"\x03\x04exit\n")
        os.waitpid(pid, 0)
        return typed

    def answer(self, terminal, text, awaited):
        """What the terminal shows, up to what is awaited, or until it is silent."""
        os.write(terminal, text.encode())
        shown, end = "", time.monotonic() + 60
        while time.monotonic() < end:
            silence = 60 if awaited else 1.5
            if not select.select([terminal], [], [], silence)[0]:
                break
            shown += os.read(terminal, 65536).decode(errors="replace").replace("\r", "")
            if awaited and awaited in shown:
                break
        return shown

    def test_commands(self):
        self.assertEqual(self.bash("springcheck ru"), ["run"])
        self.assertEqual(self.fish("springcheck ru"), ["run"])
        self.assertRegex(self.zsh("springcheck stab"), r"springcheck stability\b")

    def test_options_of_the_command(self):
        self.assertEqual(self.bash("springcheck run compression --cell-"), ["--cell-type"])
        self.assertEqual(self.bash("springcheck sweep nu --cell-"), [])
        self.assertEqual(self.fish("springcheck run compression --cell-"), ["--cell-type"])
        self.assertEqual(self.fish("springcheck sweep nu --cell-"), [])
        self.assertRegex(self.zsh("springcheck run compression --cell-"), r"--cell-type\b")

    def test_values(self):
        self.assertEqual(self.bash("springcheck run compression --cell-type pri"), ["prism"])
        self.assertEqual(self.fish("springcheck run compression --cell-type pri"), ["prism"])
        self.assertRegex(self.zsh("springcheck run compression --cell-type pris"),
                         r"--cell-type prism\b")
        self.assertIn("5.1", self.bash("springcheck table "))
        self.assertIn("5.1", self.fish("springcheck table "))
        self.assertIn("measures", self.bash("springcheck list m"))
        self.assertEqual(self.bash("springcheck help stab"), ["stability"])
        self.assertEqual(self.bash("springcheck run compression --nu "), [])

    def test_values_of_a_list(self):
        line = "springcheck run compression --method mss-cf,fem-hook"
        self.assertEqual(self.bash(line), ["mss-cf,fem-hooke"])
        self.assertEqual(self.fish(line), ["mss-cf,fem-hooke"])
        self.assertRegex(self.zsh(line), r"mss-cf,fem-hooke\b")

    def test_files_and_folders(self):
        self.assertIn("mine.toml", self.bash("springcheck run mi"))
        self.assertIn("my results.h5", self.bash("springcheck report m"))
        self.assertEqual(self.bash("springcheck report x.h5 --out f"), ["folder"])
        self.assertNotIn("mine.toml", self.bash("springcheck report x.h5 --out m"))
        self.assertIn("mine.toml", self.fish("springcheck run mi"))
        self.assertIn("folder/", self.fish("springcheck report x.h5 --out f"))
        self.assertNotIn("mine.toml", self.fish("springcheck table mi"))
        self.assertRegex(self.zsh("springcheck run min"), r"run mine\.toml")

    def test_the_zsh_script_can_be_evaluated(self):
        run = subprocess.run(
            ["zsh", "-f", "-c", "autoload -U compinit; compinit -u -D; eval \"$("
             + PROGRAM + " completion zsh)\"; print $_comps[springcheck]"],
            capture_output=True, text=True, check=True)
        self.assertEqual((run.stdout, run.stderr), ("_springcheck\n", ""))


if __name__ == "__main__":
    unittest.main()
