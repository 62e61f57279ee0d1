"""What the documentation names there is: commands, options, methods, tables, measures, files
and links. Documentation of a thing that was removed fails here."""

import json
import os
import pathlib
import re
import subprocess
import unittest

from pages import ROOT, all_pages, parts

PROGRAM = os.environ.get("SPRINGCHECK", str(ROOT / "build/release/springcheck"))
FOLDERS = ("mss", "fem_reference", "meshing", "comparisons", "tests", "reports", "dynamics",
           "tissue", "cmake", "scripts", "docs")


def printed(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True,
                          check=True).stdout


def options_in(text):
    return set(re.findall(r"(?<![\w-])--[a-z][\w-]*", text))


LISTS = json.loads(printed("list", "--json"))
COMMANDS = re.findall(r"^  ([a-z]+) ", printed("help").split("\nCommands:\n")[1], re.M)
OPTIONS = {command: options_in(printed(command, "--help")) | {"--verbose"}
           for command in COMMANDS}
EVERY_OPTION = set.union(*OPTIONS.values())


def inline_code(page):
    """(line, text) of `code` outside fences."""
    fenced = False
    for number, line in enumerate(page.read_text().splitlines(), 1):
        if line.startswith("```"):
            fenced = not fenced
        elif not fenced:
            for code in re.findall(r"(?<!`)`([^`]+)`(?!`)", line):
                yield number, code


def commands_of(page):
    """(place, command line) of every use of the program, in prose and in fences."""
    name = page.relative_to(ROOT)
    for number, code in inline_code(page):
        if code.startswith("springcheck "):
            yield f"{name}:{number}", code
    for part in parts(page):
        if getattr(part, "language", "") == "sh":
            text = part.text.replace("\\\n", " ")
            for line in re.findall(r"^springcheck .*", text, re.M):
                yield f"{name}:{part.line}", re.sub(r"\s#.*", "", line)


class Vocabulary(unittest.TestCase):
    def test_commands_and_their_options(self):
        seen = 0
        for page in all_pages():
            for place, line in commands_of(page):
                command = line.split()[1]
                if command.startswith("--") or command in ("COMMAND",):
                    continue
                self.assertIn(command, COMMANDS, f"{place}: {line}")
                unknown = options_in(line) - OPTIONS[command]
                self.assertFalse(unknown, f"{place}: {line}")
                seen += 1
        self.assertGreater(seen, 60)

    def test_options_named_alone(self):
        scripts = set()  # options of our scripts
        for script in (ROOT / "scripts").glob("*.sh"):
            scripts |= options_in(script.read_text())
        for page in all_pages():
            for number, code in inline_code(page):
                if code.startswith("--"):
                    unknown = options_in(code) - EVERY_OPTION - scripts - self.others(page)
                    self.assertFalse(unknown, f"{page}:{number}: {code}")

    def others(self, page):
        """Options of other programs, by the page that speaks of them."""
        return {"many-machines.md": {"--forceall"}}.get(page.name, set())

    def test_methods(self):
        names = set(LISTS["methods"]) | {"fem-reference"}
        for page in all_pages():
            for number, line in enumerate(page.read_text().splitlines(), 1):
                for word in re.findall(r"\b(?:mss|fem)-[a-z0-9]+(?:-[a-z0-9]+)*", line):
                    family = [name for name in names if name.startswith(word + "-")]
                    self.assertTrue(word in names or family, f"{page}:{number}: {word}")

    def test_tables_scenes_and_sweeps(self):
        for page in all_pages():
            for place, line in commands_of(page):
                words = line.split()
                if len(words) < 3 or words[2].startswith("-") or words[2].isupper():
                    continue
                for command, kind in (("table", "tables"), ("run", "scenes"),
                                      ("list", None), ("sweep", "sweeps")):
                    if words[1] == command and not words[2].endswith(".toml"):
                        known = LISTS[kind] if kind else LISTS
                        self.assertIn(words[2], known, f"{place}: {line}")
            for number, code in inline_code(page):
                if found := re.match(r"table ([a-z0-9.-]+)", code):
                    self.assertIn(found[1], LISTS["tables"], f"{page}:{number}: {code}")

    def test_words_with_underscores_are_measures_or_columns(self):
        """As volume_error; folders and files of ours apart."""
        known = set(LISTS["measures"]) | set(LISTS["columns"]) | set(LISTS["statuses"])
        known |= set(LISTS["gate-keys"]) | set(LISTS["cut-keys"])
        spoken = " ".join(LISTS["result-file"].values())
        for page in (ROOT / "docs/reference").glob("*.md"):
            for number, code in inline_code(page):
                if re.fullmatch(r"[a-z]+(_[a-z0-9]+)+", code):
                    self.assertTrue(code in known or code in spoken, f"{page}:{number}: {code}")

    def test_files_of_the_repository(self):
        for page in all_pages():
            for number, code in inline_code(page):
                if re.fullmatch(rf"({'|'.join(FOLDERS)})/[\w./-]+", code):
                    there = (ROOT / code).exists() or list(ROOT.glob(code + ".*"))
                    self.assertTrue(there, f"{page}:{number}: {code}")

    def test_links_of_the_pages_outside_the_site(self):
        """Those within the site, Sphinx checks."""
        for page in (ROOT / "README.md", ROOT / "CONTRIBUTING.md"):
            for target in re.findall(r"\]\(([^)#]+)", page.read_text()):
                if not target.startswith("http"):
                    self.assertTrue((page.parent / target).exists(), f"{page}: {target}")

    def test_commands_run_elsewhere_are_run_by_a_test(self):
        tests = subprocess.run(["ctest", "--show-only"], capture_output=True, text=True,
                               cwd=pathlib.Path(PROGRAM).parent).stdout
        for page in all_pages():
            for part in parts(page):
                if name := part.marks.get("run by"):
                    self.assertRegex(tests, rf" {re.escape(name)}\b", f"{page}:{part.line}")

    def test_readme_is_one_page(self):
        self.assertLessEqual(len((ROOT / "README.md").read_text().splitlines()), 150)

    def test_changelog_and_citation_are_of_this_version(self):
        version = printed("--version").split()[1]
        self.assertIn(f"\nversion: {version}\n", (ROOT / "CITATION.cff").read_text())
        released = re.findall(r"^## \[(\d.*)\] - \d{4}-\d\d-\d\d$",
                              (ROOT / "CHANGELOG.md").read_text(), re.M)
        self.assertEqual(released[0], version)

    def test_every_page_is_reached(self):
        for index in (ROOT / "docs").rglob("index.md"):
            for page in index.parent.glob("*.md"):
                if page != index:
                    self.assertIn(page.stem, index.read_text(), f"{index}: {page.name}")


if __name__ == "__main__":
    unittest.main()
