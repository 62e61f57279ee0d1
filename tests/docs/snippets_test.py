"""Runs what a page of the documentation tells its reader to type.

    snippets_test.py PAGE [--slow] [--take-pictures]

PAGE is relative to the repository. --slow runs the commands marked slow too; without it
they are left out. --take-pictures puts the pictures that the commands made into the page's
place of them (scripts/pictures.sh).
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from pages import ROOT, Fence, Picture, parts

PROGRAM = pathlib.Path(os.environ.get("SPRINGCHECK", ROOT / "build/release/springcheck"))


def words_of(text):
    """Lines, with one space for many: columns are as wide as their longest text."""
    return [" ".join(line.split()) for line in text.splitlines() if line.strip()]


def texts_of(svg):
    """What is written in a figure of matplotlib: each text, in its comment."""
    return re.findall(r"<!-- (.+?) -->", svg.read_text())


class Reader:
    """Somebody who works through a page in an empty folder."""

    def __init__(self, page, folder):
        self.page, self.folder = page, folder
        tools = folder / ".tools"
        tools.mkdir()
        (tools / "springcheck").symlink_to(PROGRAM)
        (tools / "python3").symlink_to("/usr/bin/python3")
        self.environment = {**os.environ, "PATH": f"{tools}:{os.environ['PATH']}",
                            "SPRINGCHECK_CLONE": str(ROOT)}
        self.output = ""

    def place(self, part):
        return f"{self.page.relative_to(ROOT)}:{part.line}"

    def save(self, fence):
        if same := fence.marks.get("same as"):
            if (ROOT / same).read_text() != fence.text:
                raise AssertionError(f"{self.place(fence)}: expected the text of {same}, got "
                                     f"another")
        file = self.folder / fence.file
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(fence.text)

    def run(self, fence):
        run = subprocess.run(["bash", "-euo", "pipefail", "-c", fence.text], cwd=self.folder,
                             env=self.environment, text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT)
        self.output = run.stdout
        expected = int(fence.marks.get("exit status", 0))
        if run.returncode != expected:
            raise AssertionError(f"{self.place(fence)}: expected exit status {expected}, got "
                                 f"{run.returncode}\n{fence.text}\n{run.stdout}")

    def compare(self, fence):
        """Every line must be the beginning of a line of the output, in order."""
        printed = iter(words_of(self.output))
        for line in words_of(fence.text):
            if not any(candidate.startswith(line) for candidate in printed):
                raise AssertionError(f"{self.place(fence)}: expected the output to have the "
                                     f"line '{line}', got\n{self.output}")

    def look(self, picture, take):
        made = self.folder / picture.made
        if take:
            shutil.copyfile(made, picture.path)
        # The words of a figure, not its coordinates, whose last digits are a machine's.
        if texts_of(made) != texts_of(picture.path):
            raise AssertionError(f"{self.place(picture)}: {picture.path.name} is not what the "
                                 f"commands make; bash scripts/pictures.sh")


class Snippets(unittest.TestCase):
    page, slow, take = ROOT / "README.md", False, False

    def test_what_the_page_says_works(self):
        with tempfile.TemporaryDirectory() as folder:
            reader = Reader(self.page, pathlib.Path(folder))
            ran = True
            for part in parts(self.page):
                if "run by" in part.marks or ("slow" in part.marks and not self.slow):
                    ran = False
                elif isinstance(part, Picture):
                    reader.look(part, self.take)
                elif part.file:
                    reader.save(part)
                elif part.language == "sh":
                    reader.run(part)
                    ran = True
                elif part.language == "text" and ran:
                    reader.compare(part)
                elif part.language != "text":
                    self.fail(f"{reader.place(part)}: expected sh, text, or a file with a "
                              f"caption, got a fence of '{part.language}'")


if __name__ == "__main__":
    arguments = sys.argv[1:]
    for option, name in (("--slow", "slow"), ("--take-pictures", "take")):
        if option in arguments:
            arguments.remove(option)
            setattr(Snippets, name, True)
    Snippets.page = ROOT / arguments.pop(0)
    unittest.main(argv=[sys.argv[0], *arguments])
