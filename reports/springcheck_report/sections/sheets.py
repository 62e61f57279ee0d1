"""Tables of our own figures, as `springcheck table` makes them."""

from content import paragraph, table, table_links
from markupsafe import Markup
from numbers_shown import data, formatted, with_bar


def sheet_blocks(document, limit=80):
    """Blocks of one table: rows, notes, files. A number with an error bar in a column of
    its own is shown with it, to the bar's digits."""
    columns = document["columns"]
    bars = {c["key"].removesuffix("_bar") for c in columns if c["key"].endswith("_bar")}
    shown = [c for c in columns if not c["key"].endswith("_bar")]
    notes = []
    for row in document["rows"]:
        notes += [note for note in row["notes"] if note not in notes]
    rows = []
    for row in document["rows"]:
        cells = [_cell(column, row, bars) for column in shown]
        cells.append(" ".join(str(notes.index(note) + 1) for note in row["notes"]))
        cells.append(((row["case"] or "")[:8], "key"))
        rows.append(cells)
    headings = [c["heading"] for c in shown] + ["notes", "case"]
    used = [i for i in range(len(headings)) if any(_text(row[i]) for row in rows)]
    headings = [headings[i] for i in used]
    rows = [[row[i] for i in used] for row in rows]
    blocks = [table(headings, rows, name=document["table"], limit=limit)]
    blocks += [paragraph('<span class="note">{}</span>', note) for note in document["notes"]]
    if notes:
        items = Markup("").join(Markup("<li>{}</li>").format(note) for note in notes)
        blocks.append(Markup('<ol class="note">{}</ol>').format(items))
    return [*blocks, table_links(document["table"])]


def _text(cell):
    return cell[0] if isinstance(cell, tuple) else cell


def _cell(column, row, bars):
    key = column["key"]
    value = row[key]
    if value is None:
        status = row.get("status", "")
        is_number = column["format"] is not None
        return (status.replace("_", " "), "failed") if is_number and status != "ok" else ""
    if column["format"] is None:
        return (value.replace("_", " "), "failed") if key == "status" and value != "ok" else value
    if key in bars and row[f"{key}_bar"]:
        text = " ± ".join(with_bar(value, row[f"{key}_bar"]))
    else:
        text = formatted(value, column["format"])
    return Markup(data(value, text))
