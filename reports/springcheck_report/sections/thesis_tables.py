"""The thesis's tables with printed value, ours and difference."""

import math

from content import Figure, Section, document_blocks, paragraph, tabled_number
from figures import agreement
from markupsafe import Markup
from numbers_shown import data, formatted, with_bar

_SHORT = {"5.1": "compression", "5.2": "tension", "5.3": "shearing", "5.4": "torsion"}


def thesis_tables(study):
    """Every table of the thesis that the file has cases of, after one figure of them all."""
    documents = (study.tables.get(name) for name in study.vocabulary["tables"])
    tables = [document for document in documents if document and "quantity" in document]
    if not tables:
        return None
    section = Section("thesis-tables", "The thesis's tables: printed and ours")
    section.blocks.append(
        paragraph(
            "Printed: K. Golec, <cite>Hybrid 3D Mass Spring System for Soft Tissue "
            "Simulation</cite>, PhD thesis, Lyon 2018. Ours: static equilibria of the same "
            "scenes, converged on their mesh to nine digits unless they wrinkle, and shown with at "
            "least the printed digits. The deeper the colour, the larger the difference, deepest "
            "from 2 points of volume change or 10 % on; a status other than ok says why a figure is "
            "not one to compare, or that there is none. The column of finite elements is the "
            "reference of these tables; the tests below compare with Hencky's law where they can."
        )
    )
    glance = [_differences(document) for document in tables if document["table"] in _SHORT]
    glance = [entry for entry in glance if entry[3]]
    if glance:
        section.blocks.append(
            Figure(
                "printed_and_ours",
                "Ours against printed, figure by figure: differences in points of volume "
                "change (tables 5.1, 5.2) and in percent of force and torque (5.3, 5.4). Hollow "
                "markers are states that wrinkle.",
                agreement.draw,
                (glance,),
            )
        )
    for document in tables:
        section.blocks += thesis_table(document)
    return section


def thesis_table(document):
    """Blocks of one table: heading, rows, notes, files."""
    unit = "" if document["unit"] == "-" else f" [{document['unit']}]"
    points = " [points]" if document["unit"] == "%" else unit
    columns = [
        *((label, lambda row, label=label: _label(row[label])) for label in document["labels"]),
        (f"printed{unit}", lambda row: row["printed_text"] or ""),
        (f"ours{unit}", lambda row: _ours(document, row)),
        (f"ours − printed{points}", lambda row: _difference(document, row)),
        (f"finite elements{unit}", lambda row: _reference(document, row)),
        ("their law", lambda row: row["reference"] or ""),
        ("printed instabilities", lambda row: row["printed_instabilities"] or ""),
        ("status", lambda row: _status(row)),
        *(
            (further["key"], lambda row, further=further: _further(further, row))
            for further in document["further"]
        ),
    ]
    rows = [[cell(row) for _, cell in columns] for row in document["rows"]]
    title = Markup("<h3>{}</h3>").format(document["title"])
    return [title, *document_blocks(document, [heading for heading, _ in columns], rows)]


def _label(value):
    """Numbers of cells come as a list."""
    return "×".join(map(str, value)) if isinstance(value, list) else value


def _ours(document, row):
    if row["ours"] is None:
        return row["status"].replace("_", " "), "failed"
    text = formatted(row["ours"], document["format"])
    return tabled_number(document, row["ours"], text, row["case"])


def relative_size(document, row):
    """How large a difference is, for colours: points of volume change over 2, all else over
    a tenth of what is printed; None without a difference."""
    if row["difference"] is None:
        return None
    if document["unit"] == "%":
        return abs(row["difference"]) / 2
    return abs(row["difference"] / row["printed"]) / 0.1


def _difference(document, row):
    size = relative_size(document, row)
    if size is None:
        return ""
    text = formatted(row["difference"], "{:+" + document["format"].removeprefix("{:"))
    level = min(4, math.ceil(4 * size)) if size > 0.02 else 0
    return Markup(data(row["difference"], text.replace("-", "−"))), f"difference-{level}"


def _reference(document, row):
    value, bar = row["reference_value"], row["reference_bar"]
    if value is None:
        return ""
    if bar is None:
        return Markup(data(value, formatted(value, document["format"])))
    value_text, bar_text = with_bar(value, bar)
    return Markup(data(value, f"{value_text} ± {bar_text}"))


def _further(further, row):
    value = row[further["key"]]
    return "" if value is None else Markup(data(value, formatted(value, further["format"])))


def _status(row):
    flags = row["flags"]
    words = flags if row["status"] in flags else [row["status"], *flags]
    text = ", ".join(words).replace("_", " ")
    return (text, "" if row["status"] == "ok" else "failed")


def _differences(document):
    """For the figure of them all."""
    points = document["unit"] == "%"
    methods = {}
    for row in document["rows"]:
        if row["difference"] is None or row["printed"] in (None, 0) and not points:
            continue
        printed, difference, usable = methods.setdefault(row["method"], ([], [], []))
        printed.append(row["printed"])
        difference.append(row["difference"] if points else 100 * row["difference"] / row["printed"])
        usable.append(row["status"] == "ok")
    name = document["table"]
    return f"{name} {_SHORT[name]}", document["unit"], "points" if points else "%", methods
