"""The scripts of `springcheck completion` complete, in bash, zsh and fish themselves."""

import functools
import os
import pathlib
import pty
import re
import select
import signal
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.environ["SPRINGCHECK"]


@functools.cache
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
        words = re.findall(r"[:=]|[^ :=]+|(?<= )$", line)  # as bash does
        quoted = " ".join(f"'{word}'" for word in words)
        (self.path / "script").write_text(
            script("bash") + f"compopt() {{ :; }}\nCOMP_WORDS=({quoted})\n"
            f"COMP_CWORD={len(words) - 1}\n_springcheck\n"
            'for reply in "${COMPREPLY[@]}"; do echo "$reply"; done\n')
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

    def zsh(self, line, expected):
        """A tab behind the line makes it end as expected, in an interactive zsh."""
        (self.path / "_springcheck").write_text(script("zsh"))
        self.typed(["zsh", "-f"], f"PS1='$ '; fpath=({self.path} $fpath); "
                   "autoload -U compinit; compinit -u -D", line, expected)

    def interactive_bash(self, line, expected):
        (self.path / "script").write_text(script("bash"))
        self.typed(["bash", "--norc", "--noprofile"], "PS1='$ '; source ./script", line, expected)

    def typed(self, shell, setting_up, line, expected):
        pid, terminal = pty.fork()
        if pid == 0:
            os.chdir(self.path)
            os.execvpe(shell[0], shell, os.environ | {"TERM": "dumb", "COLUMNS": "200"})
        self.addCleanup(os.close, terminal)
        self.answer(terminal, setting_up + "; echo rea''dy\n", "\nready", 60)
        shown = self.answer(terminal, line + "\t", expected, 60)
        shown += self.answer(terminal, "", None, 0.3)  # errors, if there are any
        os.kill(pid, signal.SIGKILL)
        os.waitpid(pid, 0)
        self.assertIn(expected, shown)
        self.assertNotIn("bad option", shown)
        self.assertLess(shown.count("\n"), 3, shown)

    def answer(self, terminal, text, awaited, seconds):
        """What the terminal shows in that time, or up to what is awaited."""
        os.write(terminal, text.encode())
        shown, end = "", time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0 and not (awaited and awaited in shown):
            if select.select([terminal], [], [], left)[0]:
                shown += os.read(terminal, 65536).decode(errors="replace").replace("\r", "")
        return shown

    def test_commands(self):
        self.assertEqual(self.bash("springcheck ru"), ["run"])
        self.assertEqual(self.fish("springcheck ru"), ["run"])
        self.zsh("springcheck stab", "springcheck stability")

    def test_options_of_the_command(self):
        self.assertEqual(self.bash("springcheck run compression --cell-"), ["--cell-type"])
        self.assertEqual(self.bash("springcheck sweep nu --cell-"), [])
        self.assertEqual(self.fish("springcheck run compression --cell-"), ["--cell-type"])
        self.assertEqual(self.fish("springcheck sweep nu --cell-"), [])
        self.zsh("springcheck run compression --cell-", "--cell-type")

    def test_values(self):
        self.assertEqual(self.bash("springcheck run compression --cell-type pri"), ["prism"])
        self.assertEqual(self.fish("springcheck run compression --cell-type pri"), ["prism"])
        self.zsh("springcheck run compression --cell-type pris", "--cell-type prism")
        self.assertIn("5.1", self.bash("springcheck table "))
        self.assertIn("5.1", self.fish("springcheck table "))
        self.assertIn("measures", self.bash("springcheck list m"))
        self.assertEqual(self.bash("springcheck help stab"), ["stability"])
        self.assertEqual(self.bash("springcheck run compression --nu "), [])
        self.assertEqual(self.bash("springcheck run torsion --stiffness-form "), ["mu", "E"])
        self.assertIn("method,nu", self.bash("springcheck export x.h5 --columns method,n"))
        self.assertNotIn("mss-cf", self.bash("springcheck chart torsion --converged-law "))

    def test_values_behind_signs_at_which_bash_breaks_words(self):
        self.assertEqual(self.bash("springcheck run compression --cell-type=pri"), ["prism"])
        self.assertEqual(self.bash("springcheck run compression --cell-type="),
                         self.bash("springcheck run compression --cell-type "))
        elements = ["q1", "q1-sri", "q1-nodal", "q2"]
        for before in ("--method ", "--method=", "--method mss-cf,", "--method=fem-hooke:q2,"):
            line = f"springcheck run compression {before}fem-stvk:"
            self.assertEqual(self.bash(line), elements, line)
            self.assertEqual(self.bash(line + "q1-"), ["q1-sri", "q1-nodal"], line)
        self.assertEqual(self.bash("springcheck run torsion --method fem-explicit-hooke:"),
                         ["q1", "q1-sri", "q1-nodal"])
        self.assertEqual(self.bash("springcheck run torsion --method fem-stvk:q2,mss-baud"),
                         ["q2,mss-baudet"])
        self.interactive_bash("springcheck run x --method fem-stvk:q1-n", "fem-stvk:q1-nodal")
        self.interactive_bash("springcheck run compression --cell-type=pri", "--cell-type=prism")
        self.interactive_bash("springcheck run x --method fem-stvk:q2,mss-baud",
                              "--method fem-stvk:q2,mss-baudet")
        self.zsh("springcheck run compression --cell-type=pri", "--cell-type=prism")
        self.assertEqual(self.fish("springcheck run compression --cell-type=pri"),
                         ["--cell-type=prism"])

    def test_behind_verbose_and_names_of_commands_elsewhere(self):
        self.assertEqual(self.bash("springcheck --verbose ru"), ["run"])
        self.assertEqual(self.fish("springcheck --verbose ru"), ["run"])
        self.zsh("springcheck --verbose stab", "--verbose stability")
        self.assertNotIn("compression", self.fish("springcheck help run "))
        self.assertNotIn("5.1", self.fish("springcheck sweep nu --out table "))

    def test_the_second_value_is_not_offered_as_the_first(self):
        self.assertIn("thesis", self.bash("springcheck gate "))
        self.assertNotIn("thesis", self.bash("springcheck gate thesis "))
        self.assertIn("my results.h5", self.bash("springcheck gate thesis "))
        self.assertEqual(self.bash("springcheck run compression --force-dt "), [])
        self.assertIn("mine.toml", self.bash("springcheck merge all.h5 part.h5 "))
        self.assertIn("thesis", self.fish("springcheck gate "))
        self.assertNotIn("thesis", self.fish("springcheck gate thesis "))
        self.assertIn("mine.toml", self.fish("springcheck gate thesis "))
        self.assertNotIn("compression", self.fish("springcheck run compression --force-dt "))

    def test_options_that_take_several_files(self):
        self.assertIn("mine.toml", self.bash("springcheck table 5.1 --from x.h5 mi"))
        self.zsh("springcheck table 5.1 --from x.h5 --fro", "--from x.h5 --from")

    def test_values_of_a_list(self):
        line = "springcheck run compression --method mss-cf,mss-baud"
        self.assertEqual(self.bash(line), ["mss-cf,mss-baudet"])
        self.assertEqual(self.fish(line), ["mss-cf,mss-baudet"])
        self.zsh(line, "mss-cf,mss-baudet")

    def test_files_and_folders(self):
        self.assertIn("mine.toml", self.bash("springcheck run mi"))
        self.assertIn("my results.h5", self.bash("springcheck report m"))
        self.assertEqual(self.bash("springcheck report x.h5 --out f"), ["folder"])
        self.assertNotIn("mine.toml", self.bash("springcheck report x.h5 --out m"))
        self.assertIn("mine.toml", self.fish("springcheck run mi"))
        self.assertIn("folder/", self.fish("springcheck report x.h5 --out f"))
        self.assertNotIn("mine.toml", self.fish("springcheck table mi"))
        self.zsh("springcheck run min", "run mine.toml")

    def test_the_zsh_script_can_be_evaluated(self):
        run = subprocess.run(
            ["zsh", "-f", "-c", "autoload -U compinit; compinit -u -D; eval \"$("
             + PROGRAM + " completion zsh)\"; print $_comps[springcheck]"],
            capture_output=True, text=True, check=True)
        self.assertEqual((run.stdout, run.stderr), ("_springcheck\n", ""))


if __name__ == "__main__":
    unittest.main()
