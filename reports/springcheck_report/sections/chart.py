"""Speed against accuracy: what `springcheck chart` measured, with claims and fronts."""

from case_words import load_text
from content import Section, file_name, paragraph, table, table_links, tabled_number
from markupsafe import Markup
from numbers_shown import formatted, with_bar
from sections.chart_figures import answer_of, figures_against

_TABLES = ["chart", "chart-front", "chart-laws", "chart-converged", "chart-claims"]
_BARS = ["answer_bar", "volume_bar", "deviation_bar"]
_APART = ["answer_apart", "volume_apart", "deviation_apart"]
_TIMES = ["median", "lower_quartile", "upper_quartile"]


def chart(study):
    """Of every chart: figures against the truth of the scene's own law, claims, front,
    what failed; figures of the other laws folded away."""
    if not study.charts:
        return None
    section = Section("chart", "Speed against accuracy")
    rows = {name: _rows_by_chart(study, name) for name in _TABLES if name != "chart-laws"}
    section.blocks += _introduction(study)
    section.blocks += _truths(study, rows["chart-converged"])
    names = []
    for place, one in enumerate(study.charts):
        own = {name: parts[place] for name, parts in rows.items()}
        section.blocks += _scene_blocks(study, one, own, names)
    section.blocks.append(Markup("<h3>Files</h3>"))
    for name in _TABLES:
        section.blocks.append(Markup("<p>{}.</p>{}").format(study.tables[name]["title"], table_links(name)))
    return section


def _rows_by_chart(study, name):
    """Rows of a table for each chart: two may be of one scene."""
    rows = study.tables[name]["rows"]
    return [[row for row in rows if row["part"] == one["identity"]] for one in study.charts]


def _introduction(study):
    errors, *times = study.tables["chart"]["notes"]
    return [
        paragraph(
            "Every model on meshes of several sizes: how far it is off what its law converges to, and how "
            "long it takes. A model is worth its time where no other is both faster and more accurate: on "
            "the Pareto front. {} Numbers of the figures are in "
            '<a href="data/charts.json">data/charts.json</a>.',
            errors,
        ),
        *(paragraph("{}", text) for text in [*times, *study.tables["chart-front"]["notes"][1:]]),
    ]


def _truths(study, parts):
    document, rows = study.tables["chart-converged"], []
    for one, truths in zip(study.charts, parts):
        for row, truth in zip(truths, one["truths"]):
            name, unit = answer_of(one)
            rows.append(
                [
                    _heading(study, one),
                    row["law"],
                    f"{name} [{unit}]",
                    _with_bar(document, row, "answer", truth["answer"]["bar"]),
                    _order(document, row, "answer"),
                    _with_bar(document, row, "volume_change", 100 * truth["volume_change"]["bar"]),
                    _order(document, row, "volume"),
                    *(_bar(document, row, bar, apart) for bar, apart in zip(_BARS, _APART)),
                ]
            )
    heads = ["scene", "law", "answer", "value", "order", "volume change [%]", "order"]
    heads += [f"{measure} unsure by, and limits apart [%]" for measure in ("force", "volume", "deviation")]
    said = dict.fromkeys(note for truths in parts for row in truths for note in row["notes"])
    notes = [paragraph('<span class="note">{}</span>', note) for note in [*document["notes"], *said]]
    return [Markup("<h3>{}</h3>").format(document["title"]), table(heads, rows, name="chart-converged"), *notes]


def _with_bar(document, row, key, bar):
    return tabled_number(document, row[key], " ± ".join(with_bar(row[key], bar)), row["case"])


def _order(document, row, of):
    """With the elements that tell it."""
    return Markup("{}, {}").format(_number(document, row, f"{of}_order", "{:.2f}"), row[f"{of}_element"])


def _bar(document, row, bar, apart):
    return Markup("{}, {}").format(*(_number(document, row, key, "{:.2g}") for key in (bar, apart)))


def _number(document, row, key, form):
    if not isinstance(row[key], int | float):
        return row[key] or "none"
    return tabled_number(document, row[key], formatted(row[key], form), row["case"])


def _heading(study, one):
    """The scene with its load, and what tells it from other charts of the same."""
    load = load_of(study, one)
    alike = [other for other in study.charts if load_of(study, other) == load]
    for difference in (_finest_cells, lambda chart: f"on {chart['machine']}"):
        if any(difference(other) != difference(one) for other in alike):
            load = f"{load}, {difference(one)}"
    return load


def _finest_cells(one):
    sizes = [f"{1000 * truth['finest_cell_size']:.3g}" for truth in one["truths"]]
    return f"converged on cells down to {min(sizes, key=float, default='no')} mm"


def load_of(study, one):
    found = (study.case(point["case"]) for point in one["points"] if point["kind"] == "equilibrium")
    case = next((case for case in found if case is not None), None)
    if case is None:
        return one["scene"]
    return ", ".join(text for text in (one["scene"], load_text(case), f"nu {case.nu:g}") if text)


def _scene_blocks(study, one, rows, names):
    name = _new_name(f"chart_{file_name(one['scene'])}", names)
    laws = [truth["law"] for truth in one["truths"]]
    heading = _heading(study, one)
    blocks = [Markup("<h3>{}</h3>").format(heading)]
    if one["quick"]:
        blocks.append(_how_to_complete(study, one))
    if one["law"] not in laws:
        blocks.append(
            paragraph("{}, the scene's own law, has no converged solution here: one of its grids failed.", one["law"])
        )
    blocks += figures_against(one, [one["law"]], name, heading)
    blocks += _claims(study, rows["chart-claims"], name)
    blocks += _front(study, one, rows["chart-front"], name)
    blocks += _unusual(study, rows["chart"])
    others = [law for law in laws if law != one["law"]]
    figures = figures_against(one, others, name, heading)
    if figures:
        opened = "<details><summary>The same against what {} converge to</summary>"
        blocks += [Markup(opened).format(", ".join(others)), *figures, Markup("</details>")]
    return blocks


def _how_to_complete(study, one):
    models = len({point["model"] for point in one["points"]})
    sizes = sorted({point["across"] for point in one["points"]})
    return paragraph(
        "A quick chart: {} models on {} cells across. <code>springcheck chart {} --out {}</code>, with the "
        "settings of this chart if it has any, adds all other models, finer cells and what the other laws "
        "converge to, in about ten minutes.",
        models,
        ", ".join(f"{size:g}" for size in sizes),
        one["scene"],
        study.results.path.name,
    )


def _new_name(name, names):
    """The name, with a number where another chart has it already."""
    names.append(name)
    count = names.count(name)
    return name if count == 1 else f"{name}_{count}"


def _claims(study, rows, name):
    if not rows:
        return []
    document = study.tables["chart-claims"]
    cells = [
        [
            f"{row['kind']}: {row['measure']}",
            row["springs"],
            *((row[key], row[key]) for key in ("faster", "as_accurate", "faster_at_equal_accuracy")),
            Markup('<span data-table="chart-claims" data-cases="{}">{}</span>').format(
                " ".join(row["cases"]), row["words"]
            ),
        ]
        for row in rows
    ]
    heads = ["of", "springs", "faster on the same cells", "as accurate there"]
    heads += ["faster at equal accuracy", "by the figures"]
    notes = [paragraph('<span class="note">{}</span>', note) for note in document["notes"]]
    title = Markup("<h4>{}</h4>").format(document["title"])
    return [title, table(heads, cells, name=f"claims-{name}", classes="claims"), *notes]


def _front(study, one, rows, name):
    """Against the truth of the scene's own law."""
    document = study.tables["chart-front"]
    own = [row for row in rows if row["law"] == one["law"]]
    if not own:
        return []
    notes = list(dict.fromkeys(note for row in own for note in row["notes"]))
    cells = [
        [
            f"{row['kind']}: {row['measure']}",
            row["model"],
            f"{row['across']:.0f}",
            f"{row['threads']:.0f}",
            *(_number(document, row, key, "{:.3g}") for key in ("error", *_TIMES)),
            _number(document, row, "rivals", "{:.0f}"),
            " ".join(str(notes.index(note) + 1) for note in row["notes"]),
            (row["case"][:8], "key"),
        ]
        for row in own
    ]
    heads = ["of", "model", "across", "threads", "off [%]"]
    heads += ["time [s, s/s]", "lower quartile", "upper quartile", "rivals", "notes", "case"]
    title = Markup("<h4>The Pareto front, over all numbers of threads</h4>")
    items = Markup("").join(Markup("<li>{}</li>").format(note) for note in notes)
    listed = [Markup('<ol class="note">{}</ol>').format(items)] if notes else []
    return [title, table(heads, cells, name=f"front-{name}"), *listed]


def _unusual(study, rows):
    """Sentences that name what failed, by status, and what was not run."""
    blocks = []
    threads = {row["threads"] for row in rows}
    over = [row for row in rows if row["median"] is None]
    for reason in dict.fromkeys(row["status"] for row in over):
        own = [row for row in over if row["status"] == reason]
        text = "<b>Not run, {}</b> (numbers are of cells across): {}."
        blocks.append(paragraph(text, reason, _models(study, own, threads)))
    failed = [row for row in rows if row["median"] is not None and row["status"] != "ok"]
    for status in dict.fromkeys(row["status"] for row in failed):
        own = [row for row in failed if row["status"] == status]
        text = "<b>Failed, {}</b>: {}."
        blocks.append(paragraph(text, status.replace("_", " "), _models(study, own, threads)))
    return blocks


def _models(study, rows, all_threads):
    """"mss-cf on 6, 10 (1 thread); ...": models with the meshes, and the threads where it is
    not so on all numbers of them."""
    document, parts = study.tables["chart"], []
    for model in dict.fromkeys(row["model"] for row in rows):
        meshes = {}
        for row in rows:
            if row["model"] == model:
                meshes.setdefault(row["across"], []).append(row)
        texts = []
        for across, here in meshes.items():
            threads = [f"{row['threads']:.0f}" for row in here]
            limited = "" if len(threads) == len(all_threads) else f" (threads: {', '.join(threads)})"
            case = here[0]["case"] if study.case(here[0]["case"]) is not None else None  # never run
            texts.append(tabled_number(document, across, f"{across:.0f}", case) + limited)
        parts.append(Markup("{} on {}").format(model, Markup(", ").join(texts)))
    return Markup("; ").join(parts)
