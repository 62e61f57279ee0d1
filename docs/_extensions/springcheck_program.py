"""Directives whose text comes from the program itself, so that no page copies it by hand.

    {program-list} measures     the table of `springcheck list measures`
    {program-help} run          what `springcheck run --help` prints
    {program-commands}          a section for each command, with what its --help prints

The program is $SPRINGCHECK, or build/release/springcheck of this clone.
"""

import json
import os
import pathlib
import re
import subprocess

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("SPRINGCHECK", str(ROOT / "build/release/springcheck"))
HEADS = {"methods": "method", "scenes": "scene", "sweeps": "sweep", "settings": "setting",
         "tables": "table", "measures": "measure", "statuses": "status",
         "failures": "failure", "gate-keys": "key", "cut-keys": "key", "result-file": "group",
         "columns": "column", "exit-statuses": "exit status", "elements": "element",
         "cell-types": "cell type", "materials": "law", "tests": "test", "compared": "compared"}


def asked(*arguments):
    """What the program prints."""
    try:
        run = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=True,
                             env=os.environ | {"COLUMNS": "100"})
    except (OSError, subprocess.CalledProcessError) as error:
        detail = getattr(error, "stderr", "") or str(error)
        raise ExtensionError(f"{PROGRAM} {' '.join(arguments)}: {detail.strip()}") from error
    return run.stdout


def cell(text):
    """As a cell of a Markdown table: nothing in it is markup but `code`."""
    for mark in "\\|*_<>$[]":
        text = text.replace(mark, "\\" + mark)
    return text


def anchor(kind, name):
    return f"{kind}-{name}".replace("_", "-").replace("/", "").replace(" ", "-").lower()


def table_of(kind, entries):
    """Lines of Markdown."""
    first = next(iter(entries.values()))
    columns = [name for name in ("letter", "unit", "units")
               if isinstance(first, dict) and name in first]
    further = [name for name in ("covers", "settings", "tests", "compared", "minutes", "source")
               if isinstance(first, dict) and name in first]
    # Measures of all tests say so in a word.
    of_all, every = "all", max((entry.get("tests", []) for entry in entries.values()
                                if isinstance(entry, dict)), key=len, default=[])
    heads = [*columns, "meaning", *further]
    heads.insert(int("letter" in columns), HEADS[kind])
    lines = [f"| {' | '.join(heads)} |", "|" + " --- |" * len(heads)]
    for name, entry in entries.items():
        text = cell(entry["description"] if isinstance(entry, dict) else entry)
        if isinstance(entry, dict) and entry.get("option") is False:
            text += " (in scene files alone)"
        row = [shown(column, entry[column]) for column in columns] + [text]
        row += [of_all if entry[column] == every else shown(column, entry[column])
                for column in further]
        row.insert(int("letter" in columns), f'<span id="{anchor(kind, name)}"></span>`{name}`')
        lines.append(f"| {' | '.join(row)} |")
    return lines


def shown(column, value):
    if column == "letter":
        return f"`{value}`"
    if isinstance(value, (int, float)):
        return f"{value:g}"
    return cell(value if isinstance(value, str) else ", ".join(value))


def tables_of(kind):
    """Lines of Markdown: a table, or one for each group of the entries."""
    entries = json.loads(asked("list", kind, "--json"))[kind]
    groups = {}
    for name, entry in entries.items():
        group = entry.get("group", entry.get("family", "")) if isinstance(entry, dict) else ""
        groups.setdefault(group, {})[name] = entry
    lines = []
    for group, members in groups.items():
        title = [f"**{group[0].upper()}{group[1:]}**", ""] if group else []
        lines += ["", *title, *table_of(kind, members), ""]
    return lines


class ProgramList(SphinxDirective):
    required_arguments = 1

    def run(self):
        self.env.note_reread()  # the program may have changed, though the page did not
        kind = self.arguments[0]
        if kind not in HEADS:
            raise self.error(f"expected one of {', '.join(HEADS)}, got '{kind}'")
        node = nodes.container(classes=["program-list"])
        self.state.nested_parse(StringList(tables_of(kind), kind), self.content_offset, node)
        return [node]


def help_of(*command):
    text = asked(*command, "--help")
    return nodes.literal_block(text, text, language="text")


class ProgramHelp(SphinxDirective):
    optional_arguments = 1

    def run(self):
        self.env.note_reread()
        return [help_of(*self.arguments)]


class ProgramCommands(SphinxDirective):
    def run(self):
        self.env.note_reread()
        commands = re.findall(r"^  ([a-z]+) ", asked("help").split("\nCommands:\n")[1], re.M)
        return [nodes.section("", nodes.title(name, name), help_of(name), ids=[name], names=[name])
                for name in commands]


def setup(app):
    app.add_directive("program-list", ProgramList)
    app.add_directive("program-help", ProgramHelp)
    app.add_directive("program-commands", ProgramCommands)
    return {"version": "1", "parallel_read_safe": True}
