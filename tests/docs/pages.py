"""What the documentation's pages hold: fences of code, with the marks before them.

    ```sh                    commands, run by bash in the page's own folder, in order
    ```{code-block} toml     a file that the reader saves, named by its :caption:
    ```text                  output of the commands before: its lines must be in it

Marks are comments before a fence or a picture:

    <!-- exit status: 1 -->      how the commands end (0 unless marked)
    <!-- slow -->                minutes: run by the page's slow test alone
    <!-- run by: NAME -->        not run here but by that test
    <!-- same as: FILE -->       the file that follows is this one of the repository
    <!-- picture of: FILE -->    the picture that follows is this file, made by the commands
"""

import dataclasses
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
MARK = re.compile(r"<!-- (exit status|slow|run by|picture of|same as)(?:: (.+?))? -->")


@dataclasses.dataclass
class Fence:
    language: str
    text: str
    line: int
    file: str = ""         # where the reader saves it
    marks: dict = dataclasses.field(default_factory=dict)


@dataclasses.dataclass
class Picture:
    path: pathlib.Path     # committed
    made: str              # by the page's commands, in its folder
    line: int
    marks: dict


def all_pages():
    """README, CONTRIBUTING and every page of docs, as paths."""
    return [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]


def parts(page):
    """Fences and marked pictures of a page, in order."""
    found, marks = [], {}
    lines = page.read_text().splitlines()
    number = 0
    while number < len(lines):
        line = lines[number]
        number += 1
        if mark := MARK.fullmatch(line.strip()):
            marks[mark[1]] = mark[2] or ""
        elif line.startswith("<!--"):
            raise ValueError(f"{page}:{number}: expected a mark that pages.py knows, "
                             f"got {line}")
        elif opening := re.fullmatch(r"(`{3,})(?:\{code-block\} )?(\w*)(\{[\w-]+\}.*)?", line):
            begin = number
            while number < len(lines) and lines[number] != opening[1]:
                number += 1
            body = lines[begin:number]
            number += 1
            file = ""
            if body and (caption := re.fullmatch(r":caption: (.+)", body[0])):
                file, body = caption[1], body[1:]
            if not opening[3]:
                found.append(Fence(opening[2], "\n".join(body) + "\n", begin, file, marks))
            marks = {}
        elif image := re.search(r"!\[.*\]\((.+?)\)", line):
            if "picture of" in marks:
                found.append(Picture((page.parent / image[1]).resolve(), marks["picture of"],
                                     number, marks))
            marks = {}
        elif line.strip():
            marks = {}
    return found
