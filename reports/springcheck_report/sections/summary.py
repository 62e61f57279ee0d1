"""The first screen: what was compared, how well it agrees, where springs fail."""

import numpy as np
from content import Section, bullets, columns, measured_number, paragraph, table
from markupsafe import Markup
from numbers_shown import significant
from sections.failures import failing_sentences
from sections.thesis_tables import relative_size
from study import FAILED, case_text, is_variant

# From half a percent on, below which volumes do not change; 5 % and 0.05 rad are small.
_LEAST, _SMALL = 0.005, 0.051


def summary(study):
    section = Section("summary", "Summary")
    section.blocks += [_what(study), _agreement(study), _findings(study)]
    return section


def _what(study):
    cases = study.cases
    springs = sorted(set(cases[cases.kind == "springs"].method))
    elements = sorted(set(cases[cases.kind == "finite elements"].method))
    measured = sorted(set(cases[cases.kind == "measured"].method))
    tests = list(dict.fromkeys(cases.test))
    solvers = []
    if springs:
        solvers.append(f"mass-spring systems ({', '.join(springs)})")
    if elements:
        solvers.append(f"finite elements ({', '.join(elements)})")
    if measured:
        solvers.append(f"results of other programs ({', '.join(measured)})")
    return paragraph(
        "Elastic bodies were deformed by {} on the same meshes, in {} {}: {}. A mass-spring "
        "system replaces the body by springs and is fast; finite elements solve the equations of "
        "elasticity. This page shows how far they are apart: in volume, in the force that holds "
        "the deformed body, and in the place of its points.",
        " and ".join(solvers),
        len(cases),
        "simulation" if len(cases) == 1 else "simulations",
        ", ".join(tests),
    )


def _agreement(study):
    """Per spring method: cases, failures, medians and worst differences."""
    cases = study.cases[study.cases.kind != "finite elements"]
    cases = cases[~cases["name"].map(is_variant)]
    if cases.empty:
        return paragraph("The file holds finite elements only: there is nothing to compare.")
    rows = []
    for name in _by_usefulness(cases):
        of_method = cases[cases.method == name]
        covered = of_method[of_method.status != "refused"]
        row = [Markup("<b>{}</b>").format(name), f"{(covered.status == 'ok').sum()} of {len(covered)}"]
        small = (covered.strain >= _LEAST) & (covered.strain <= _SMALL)
        for chosen in (covered[small], covered[covered.strain > _SMALL]):
            usable = chosen[(chosen.status == "ok") & chosen.counterpart.notna()]
            row.append(_median_and_worst(study, usable, "volume_difference", "points"))
            row.append(_median_and_worst(study, usable, "answer_difference", "%"))
        rows.append(row)
    headings = [
        "method",
        "usable",
        "volume, ½ to 5 %",
        "force, ½ to 5 %",
        "volume, beyond 5 %",
        "force, beyond 5 %",
    ]
    text = Markup(
        '{}<p class="note">Distance from finite elements on the same mesh, material and '
        "deformation, methods with their usual settings (the law is named in each test below): median, and in brackets the largest. "
        "Volume in points of V₀, force (torque, drop of a tip) in percent. Usable: an equilibrium "
        "that is stable and does not wrinkle, of the cases that the method covers. Beyond 5 % most "
        "of the force's difference is the law, not the method: springs have one of their own. Near "
        "nu = 0.5 linear finite elements on other cells than hexahedra lock and judge nothing; they "
        "are left out here.</p>"
    )
    return text.format(table(headings, rows, name="summary", classes="summary"))


def _by_usefulness(cases):
    order = ["mss-cf", "mss-affine"]
    names = sorted(set(cases.method))
    return sorted(names, key=lambda name: order.index(name) if name in order else len(order))


def _median_and_worst(study, cases, measure, unit):
    sizes = 100 * cases[measure].abs()
    sizes = sizes[np.isfinite(sizes)]
    if sizes.empty:
        return ("–", "none")
    worst = sizes.idxmax()
    text = f"{_short(sizes.median())} ({_short(sizes.max())}) {unit}"
    return Markup('<span title="largest: {}">{}</span>').format(
        case_text(study.cases.loc[worst]), text
    )


def _short(value):
    return "0" if value < 0.005 else significant(value, 2)


def _findings(study):
    agreement = [*_against_print(study), *_worst_cell(study), *_counts(study)]
    return columns(
        [Markup("<h3>What agrees, what does not</h3>"), bullets(agreement)],
        [Markup("<h3>Where springs fail</h3>"), bullets(failing_sentences(study))],
    )


def _against_print(study):
    """How many of the thesis's figures are met, by method, and the furthest."""
    items = []
    for method in ("mss-cf", "fem-hencky:q1-sri"):
        judged = []
        for document in study.tables.values():
            if "quantity" not in document or document["table"] in ("deviation", "bending"):
                continue
            for row in document["rows"]:
                if row["method"] == method and row["difference"] is not None:
                    judged.append((relative_size(document, row), document, row))
        if not judged:
            continue
        near = sum(size <= 0.1 for size, _, _ in judged)
        size, document, row = max(judged, key=lambda entry: entry[0])
        labels = ", ".join(
            f"{label} {row[label]}" for label in document["labels"] if label != "method"
        )
        unit = "points" if document["unit"] == "%" else document["unit"]
        law = " (the law that reproduces the thesis's FEM column)" if "fem" in method else ""
        items.append(
            Markup(
                "<b>{}</b>{} meets {} of {} figures that the thesis prints, to 0.2 points of volume "
                "error or 1 % of force and torque. Furthest: table {}, {}: printed {}, ours {} {}."
            ).format(
                method,
                law,
                near,
                len(judged),
                document["table"],
                labels,
                row["printed_text"],
                significant(row["ours"]),
                "%" if unit == "points" else unit,
            )
        )
    return items


def _worst_cell(study):
    """The cell whose volume is furthest from the rest state, of usable springs."""
    cases = study.cases[(study.cases.kind == "springs") & (study.cases.status == "ok")]
    if cases.empty or cases.cell_volume_ratio_min.isna().all():
        return []
    key = cases.cell_volume_ratio_min.idxmin()
    case = cases.loc[key]
    number = measured_number(
        study, key, "cell_volume_ratio_min", significant(case.cell_volume_ratio_min, 3)
    )
    text = Markup("Worst cell of a usable state: pressed to {} of its volume ({}, {}").format(
        number, case["name"], case_text(case)
    )
    if case.counterpart is not None:
        theirs = study.cases.loc[case.counterpart]
        ratio = significant(theirs.cell_volume_ratio_min, 3)
        text += Markup("; smallest in {}: {}").format(
            theirs["name"],
            measured_number(study, case.counterpart, "cell_volume_ratio_min", ratio),
        )
    return [text + ")."]


def _counts(study):
    counts = study.cases.status.value_counts()
    parts = [f"{count} {status.replace('_', ' ')}" for status, count in counts.items()]
    failed = int(sum(counts.get(status, 0) for status in FAILED))
    text = Markup("{} {}: {}").format(
        len(study.cases), "case" if len(study.cases) == 1 else "cases", ", ".join(parts)
    )
    if failed:
        text += Markup('; <a href="#failures">where and why</a>')
    return [text + "."]
