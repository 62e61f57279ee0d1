"""What sections are made of: text, tables, figures, answers in pictures, the explorer, 3D views."""

import re
from collections.abc import Callable
from dataclasses import dataclass, field

from markupsafe import Markup
from numbers_shown import data


@dataclass
class Figure:
    """name: of its files. draw(*arguments) makes matplotlib's Figure; another process
    may call it. caption: what it shows and how to read it, a sentence or two."""

    name: str
    caption: str
    draw: Callable
    arguments: tuple


@dataclass
class Viewer:
    """An interactive 3D view of a test's bodies, see bodies.py."""

    test: str


@dataclass
class Answer:
    """A question, a picture half as wide as the page, and the sentence that is read off it.
    address: of what says more, within the page."""

    question: str
    figure: Figure
    sentence: Markup
    address: str


@dataclass
class Answers:
    """Answers beside each other."""

    answers: list


@dataclass
class Explorer:
    """The plot of any cases along any setting. data: see explorer.py."""

    data: dict


@dataclass
class Section:
    """blocks: Markup, Figure, Answers, Explorer and Viewer, from top to bottom."""

    name: str
    title: str
    blocks: list = field(default_factory=list)


def figures_of(section):
    """Its figures, those of answers too."""
    found = []
    for block in section.blocks:
        found += [block] if isinstance(block, Figure) else []
        found += [answer.figure for answer in block.answers] if isinstance(block, Answers) else []
    return found


def paragraph(text, *values):
    """A paragraph; whatever stands for {} in the text is escaped."""
    return Markup("<p>" + text + "</p>").format(*values)


def bullets(items):
    return Markup("<ul>{}</ul>").format(Markup("").join(Markup("<li>{}</li>").format(i) for i in items))


def columns(*blocks):
    """Lists of Markup beside each other where the page is wide enough."""
    joined = (Markup("").join(block) for block in blocks)
    parts = Markup("").join(Markup("<div>{}</div>").format(part) for part in joined)
    return Markup('<div class="columns">{}</div>').format(parts)


def file_name(text):
    """A name that every file system takes: letters, digits, dots and dashes."""
    return re.sub(r"[^A-Za-z0-9.]+", "-", text).strip("-.") or "unnamed"


def measured_number(study, key, measure, text):
    """A case's measure as `text`, with its origin."""
    return Markup(data(float(study.cases.loc[key, measure]), text, key, measure))


def tabled_number(document, value, text, case=None):
    """A number of a table of tables/ as `text`, with its origin: that table, and the case
    behind it if there is one."""
    origin = Markup(' data-case="{}"').format(case) if case else ""
    return Markup('<data value="{!r}" data-table="{}"{}>{}</data>').format(
        value, document["table"], origin, text
    )


_MANY_COLUMNS = 12


def table(headings, rows, *, name, classes=None, limit=None):
    """rows: lists of cells, Markup or text, or (cell, class). Wide tables scroll, and are
    printed across the page. Beyond `limit` rows the rest is left to the table's files."""
    is_wide = len(headings) > _MANY_COLUMNS
    classes = " ".join([*([classes] if classes else []), *(["wide"] if is_wide else [])])
    shown = rows[:limit]
    head = Markup("").join(Markup("<th scope=col>{}</th>").format(text) for text in headings)
    body = Markup("").join(
        Markup("<tr>{}</tr>\n").format(Markup("").join(_cell(cell, is_wide) for cell in row))
        for row in shown
    )
    rest = ""
    if len(shown) < len(rows):
        rest = Markup("<p class=note>The first {} of {} rows; all are in the files.</p>").format(
            len(shown), len(rows)
        )
    return Markup(
        '<div class="scroll"><table id="table-{}" class="{}"><thead><tr>{}</tr></thead>'
        "<tbody>\n{}</tbody></table></div>{}"
    ).format(name, classes, head, body, rest)


def folded(blocks, title):
    """Blocks of Markup below a line that opens them."""
    inside = Markup("").join(blocks)
    return Markup('<details class="folded"><summary>{}</summary>{}</details>').format(title, inside)


_LONG_NAME = re.compile(r"([a-z]+-[\w-]+[:-])([\w-]+)")  # of a method: is broken into these where it must be
_WORDS, _LONG = 10, 24  # characters of texts that may be broken into lines, and of those with a width of their own


def _cell(cell, is_in_wide_table):
    text, style = cell if isinstance(cell, tuple) else (cell, "")
    if is_in_wide_table and not isinstance(text, Markup) and (parts := _LONG_NAME.fullmatch(text)):
        text = Markup("<span>{}</span><wbr><span>{}</span>").format(*parts.groups())
        style = f"{style} name".strip()
    if not isinstance(text, Markup) and " " in text and len(text) > _WORDS:
        style = f"{style} {'long' if len(text) > _LONG else 'words'}".strip()
    return Markup('<td class="{}">{}</td>').format(style, text) if style else Markup(
        "<td>{}</td>"
    ).format(text)


def table_links(name):
    """To the files of a table."""
    links = [
        Markup('<a href="tables/{}.{}">{}</a>').format(name, extension, extension)
        for extension in ("csv", "md", "tex", "json")
    ]
    return Markup('<p class="files">Files: {}</p>').format(Markup(" · ").join(links))


def document_blocks(document, headings, rows, limit=None):
    """Blocks of a table of tables/: its rows (cells of `headings`, in the document's order),
    each with its notes' numbers and its case, without columns that are empty in all; then
    the notes and the files."""
    notes = list(dict.fromkeys(note for row in document["rows"] for note in row["notes"]))
    headings = [*headings, "notes", "case"]
    whole = [
        [
            *cells,
            " ".join(str(notes.index(note) + 1) for note in row["notes"]),
            ((row["case"] or "")[:8], "key"),
        ]
        for cells, row in zip(rows, document["rows"])
    ]
    used = [i for i in range(len(headings)) if any(_text(cells[i]) for cells in whole)]
    kept = [[cells[i] for i in used] for cells in whole]
    blocks = [table([headings[i] for i in used], kept, name=document["table"], limit=limit)]
    blocks += [paragraph('<span class="note">{}</span>', note) for note in document["notes"]]
    if notes:
        items = Markup("").join(Markup("<li>{}</li>").format(note) for note in notes)
        blocks.append(Markup('<ol class="note">{}</ol>').format(items))
    return [*blocks, table_links(document["table"])]


def _text(cell):
    return cell[0] if isinstance(cell, tuple) else cell
