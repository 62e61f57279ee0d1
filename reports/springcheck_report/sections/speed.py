"""Time of explicit steps: the thesis's performance study on the machine of the table."""

import methods
import numpy as np
from content import Figure, Section, paragraph, table, tabled_number
from figures import curves
from markupsafe import Markup
from method_style import NEUTRAL, line, shades
from numbers_shown import significant
from sections.documents import table_blocks, titled_table

_MOST_ROWS = 200
_UNDISTURBED = 0.9  # user over real time of one thread
# Columns that are shown in a table and a figure of their own.
_ELSEWHERE = ["figures", "steps", "printed_seconds", "seconds_as_printed"]


def speed(study):
    """From the table performance: figures 5.20 to 5.25 and the two printed times, after
    table 5.5, their meshes."""
    document = study.tables.get("performance")
    if document is None:
        return None
    machine, *notes = document["notes"]
    columns = [column for column in document["columns"] if column["key"] not in _ELSEWHERE]
    figures = [_times(document), _occupied(document), _occupied_by_threads(document), _threads(document)]
    title = Markup("<h3>{}</h3>").format(document["title"])
    section = Section("speed", "Speed")
    section.blocks += [
        paragraph("How long a step of the springs takes. {}", machine),
        *_other_work(document),
        _headline(document),
        *_printed_times(document),
        *(figure for figure in figures if figure),
        *titled_table(study.tables.get("5.5")),
        title,
        *table_blocks({**document, "notes": notes, "columns": columns}, _MOST_ROWS),
    ]
    return section


def _other_work(document):
    """A warning where one thread had less than a processor to itself."""
    least = min(row["user_over_real"] for row in document["rows"] if row["threads"] == 1)
    if least >= _UNDISTURBED:
        return []
    return [
        paragraph(
            "<b>The machine had other work meanwhile</b>: one thread got as little as {} % of a "
            "processor. Times are too long, and differ by more than methods do.",
            f"{100 * least:.0f}",
        )
    ]


def _headline(document):
    """What a step of the thesis's springs takes on one thread, over all bodies."""
    sentences, springs = [], methods.of_thesis()
    for precision in ("double", "float"):
        rows = [
            row
            for row in document["rows"]
            if (row["method"], row["precision"], row["threads"]) == (springs, precision, 1)
        ]
        if rows:
            times = _range(document, rows, "ns_per_cell_step", 2)
            ratios = _range(document, rows, "over_naive", 2)
            sentences.append(
                Markup("{} ns per cell in {} precision, {} times less than plain loops").format(
                    times, "single" if precision == "float" else precision, ratios
                )
            )
    return paragraph("On one thread a step of {} takes {}.", springs, Markup("; ").join(sentences))


def _range(document, rows, key, digits):
    ends = sorted(row[key] for row in rows)
    low, high = (tabled_number(document, end, significant(end, digits)) for end in (ends[0], ends[-1]))
    return Markup("{} to {}").format(low, high)


def _printed_times(document):
    """The two times that the thesis prints beside ours for as many steps."""
    rows = []
    for row in document["rows"]:
        if row["printed_seconds"] is None:
            continue
        steps = row["steps"] * row["seconds_as_printed"] / row["seconds"]
        ratio = row["printed_seconds"] / row["seconds_as_printed"]
        rows.append(
            [
                row["scene"],
                f"{row['cells']:.0f}",
                _thousands(steps),
                tabled_number(document, row["printed_seconds"], f"{row['printed_seconds']:g}"),
                f"{row['threads']:.0f}",
                tabled_number(document, row["seconds_as_printed"], significant(row["seconds_as_printed"], 3)),
                tabled_number(document, ratio, significant(ratio, 2)),
            ]
        )
    heads = ["scene", "cells", "steps", "printed, 8 threads of an i7-4790K [s]"]
    heads += ["our threads", "ours [s]", "printed over ours"]
    return [Markup("<h3>The two times that the thesis prints</h3>"), table(heads, rows, name="printed-times")]


def _thousands(number):
    return f"{number:,.0f}"


def _scenes(document):
    return list(dict.fromkeys(row["scene"] for row in document["rows"]))


def _most_threads(document):
    return max(row["threads"] for row in document["rows"])


def _lines(rows, along, value):
    """A curve for each method and precision: value against a setting."""
    found = []
    for method, precision in dict.fromkeys((row["method"], row["precision"]) for row in rows):
        own = [row for row in rows if (row["method"], row["precision"]) == (method, precision)]
        own.sort(key=lambda row: row[along])
        name = method if precision == "double" else f"{method}, single precision"
        x, y = (np.array([row[key] for row in own], dtype=float) for key in (along, value))
        found.append(curves.Curve(name, x, y, style=_style(method, precision)))
    return found


def _style(method, precision):
    """The method's own, dotted in single precision."""
    if method == "plain loops":
        return {"color": NEUTRAL[1], "marker": "x", "markersize": 4, "linewidth": 1.1}
    dots = {"linestyle": ":"} if precision == "float" else {}
    return {**line(method), **dots}


def _times(document):
    """Figures 5.20 and 5.21."""
    threads, panels = _most_threads(document), []
    for scene in _scenes(document):
        rows = [row for row in document["rows"] if row["scene"] == scene]
        kept = [row for row in rows if row["threads"] == threads or row["method"] == "plain loops"]
        steps = rows[0]["steps"]
        printed = next((row for row in rows if row["printed_seconds"]), None)
        own = _lines(kept, "cells", "seconds")
        if printed:
            time = printed["printed_seconds"] * printed["seconds"] / printed["seconds_as_printed"]
            star = {"linestyle": "none", "marker": "*", "markersize": 8, "color": "black"}
            own.append(
                curves.Curve("mss-cf, printed", np.array([printed["cells"]]), np.array([time]), style=star)
            )
        title = f"{scene.capitalize()} (figure {_figure_number(rows[0])})"
        y_label = f"time of {_thousands(steps)} steps [s]"
        panels.append(curves.Panel(title, "cells", y_label, own, log_x=True, log_y=True))
    caption = (
        f"Real time against cells on {_thread_text(threads)}, plain loops on one. The star is the "
        "time that the thesis prints of mss-cf with 8 threads of an i7-4790K, per so many steps."
    )
    return Figure("speed_time", caption, curves.draw, (panels,))


def _figure_number(row):
    """The first of the thesis's figures that the row is of."""
    return row["figures"].split(",")[0]


def _thread_text(count):
    return "1 thread" if count == 1 else f"{count:.0f} threads"


def _occupied(document):
    """Figure 5.22."""
    threads, panels = _most_threads(document), []
    for scene in _scenes(document):
        rows = [row for row in document["rows"] if (row["scene"], row["threads"]) == (scene, threads)]
        rows = [row for row in rows if row["method"] != "plain loops"]
        own = [*_lines(rows, "cells", "user_over_real"), _at_best(rows, threads)]
        panels.append(_ratio_panel(scene.capitalize(), own))
    caption = (
        f"User over real time on {_thread_text(threads)} (figure 5.22): how many threads worked, of "
        "that many processors at best."
    )
    return Figure("speed_occupied", caption, curves.draw, (panels,))


def _at_best(rows, threads):
    ends = np.array([min(row["cells"] for row in rows), max(row["cells"] for row in rows)], dtype=float)
    dots = {"color": NEUTRAL[2], "linestyle": (0, (1, 2)), "linewidth": 1.5}
    return curves.Curve("all threads", ends, np.full(2, threads), style=dots)


def _ratio_panel(title, lines):
    return curves.Panel(title, "cells", "user/real time", lines, log_x=True, from_zero=True)


def _occupied_by_threads(document):
    """Figures 5.23 to 5.25: mss-nfd, mss-fd, mss-cf in compression by number of threads."""
    counts = sorted({row["threads"] for row in document["rows"]})
    if len(counts) < 2:
        return None
    panels = []
    for method, number in (("mss-nfd", "5.23"), ("mss-fd", "5.24"), ("mss-cf", "5.25")):
        own = []
        for count, shade in zip(counts, shades(len(counts) + 1)):  # the last is pale
            rows = [
                row
                for row in document["rows"]
                if (row["scene"], row["method"], row["precision"], row["threads"])
                == ("compression", method, "double", count)
            ]
            style = {"color": shade, "marker": "o", "markersize": 3.5, "linewidth": 1.1}
            (curve,) = _lines(rows, "cells", "user_over_real") or [None]
            if curve:
                own.append(curves.Curve(_thread_text(count), curve.x, curve.y, style=style))
        panels.append(_ratio_panel(f"{method} (figure {number})", own))
    caption = (
        "User over real time against cells in compression, a curve for each number of threads. At "
        "best the ratio is that number; the thesis's fell towards 1 for mss-cf on many cells."
    )
    return Figure("speed_occupied_by_threads", caption, curves.draw, (panels,))


def _threads(document):
    """Time of a cell's step against threads, of the largest body of each scene."""
    if _most_threads(document) < 2:
        return None
    panels = []
    for scene in _scenes(document):
        rows = [row for row in document["rows"] if row["scene"] == scene]
        largest = max(row["cells"] for row in rows)
        own = _lines([row for row in rows if row["cells"] == largest], "threads", "ns_per_cell_step")
        title = f"{scene.capitalize()}, {_thousands(largest)} cells"
        y_label = "time per cell and step [ns]"
        panels.append(curves.Panel(title, "threads", y_label, own, log_x=True, log_y=True))
    caption = "Time of a cell's step against the number of threads, of the largest bodies."
    return Figure("speed_threads", caption, curves.draw, (panels,))
