"""Tables as `springcheck table` makes them, beside the file or of its cases."""

from content import document_blocks, folded
from markupsafe import Markup
from numbers_shown import data, formatted, with_bar

_MOST_OPEN = 30  # rows


def table_blocks(document, limit=100):
    """Blocks of one table: rows, notes, files. A number with an error bar in a column of
    its own is shown with it, to the bar's digits."""
    columns = document["columns"]
    bars = {c["key"].removesuffix("_bar") for c in columns if c["key"].endswith("_bar")}
    shown = [c for c in columns if not c["key"].endswith("_bar")]
    headings = [c["heading"] for c in shown]
    rows = [[_cell(column, row, bars) for column in shown] for row in document["rows"]]
    return document_blocks(document, headings, rows, limit)


def titled_table(document, limit=100):
    """The same below its title, where there is a table; of many rows folded."""
    if document is None:
        return []
    blocks, count = table_blocks(document, limit), len(document["rows"])
    if count > _MOST_OPEN:
        blocks = [folded(blocks, f"The table, of {count} rows")]
    return [Markup("<h3>{}</h3>").format(document["title"]), *blocks]


def _cell(column, row, bars):
    key = column["key"]
    value = row[key]
    if value is None:
        status = row.get("status", "ok")
        is_number = column["format"] is not None
        return (status.replace("_", " "), "failed") if is_number and status != "ok" else ""
    if column["format"] is None:
        return (value.replace("_", " "), "failed") if key == "status" and value != "ok" else value
    if key in bars and row[f"{key}_bar"]:
        text = " ± ".join(with_bar(value, row[f"{key}_bar"]))
    else:
        text = formatted(value, column["format"])
    return Markup(data(value, text))
