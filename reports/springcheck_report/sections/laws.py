"""What the springs' constants and laws do: from the tables split, locking, orientation,
modes."""

import measures
import methods
import numpy as np
from content import Figure, Section, paragraph
from figures import curves, error_parts as error_figures
from figures import rows as row_figures
from method_style import NEUTRAL, line, shades
from sections.documents import table_blocks


def spring_constants(study):
    """Figure 5.4, and the ratio of the diagonals."""
    if not (study.cases.kind == "springs").any():
        return None
    section = Section("spring-constants", "The springs' constants")
    modulus = study.theory.get("volume_modulus")
    corrected = study.cases.method.isin(methods.corrects_volume()) & study.cases.answer.notna()
    if modulus and corrected.any():
        formula = curves.Curve(
            "κ/E = (4ν − 1)/(2(1 + ν)(1 − 2ν))",
            np.array(modulus["nu"]),
            np.array(modulus["kappa_over_young"]),
            style={"color": NEUTRAL[0]},
        )
        dots = {"color": NEUTRAL[1], "marker": "o", "linestyle": "none", "markersize": 4}
        used = [case for case in modulus["cases"] if case["nu"] in set(study.cases[corrected].nu)]
        of_cases = curves.Curve(
            "cases of this file",
            np.array([case["nu"] for case in used]),
            np.array([case["kappa_over_young"] for case in used]),
            style=dots,
        )
        panel = curves.Panel("", study.settings["nu"]["label"], "κ/E", [formula, of_cases], symmetric_log_y=True)
        caption = (
            f"The modulus of the volume correction over Young's modulus ({modulus['source']}). "
            "It is zero at nu = 1/4, where springs alone are right, negative below, and without "
            "bound at 1/2. The axis is linear within ±1."
        )
        section.blocks.append(Figure("volume_modulus", caption, curves.draw, ([panel],)))
    section.blocks += _diagonal_ratio(study)
    return section if section.blocks else None


def _diagonal_ratio(study):
    """Answers against A for each load, over those at the smallest |log A|."""
    cases = study.cases[(study.cases.method == methods.of_thesis()) & (study.cases.test != "bending")]
    panels = []
    for test, of_test in cases.groupby("test"):
        if measures.answer(test) is None:
            continue
        lines = []
        loads = of_test.groupby(["mesh", "nu", "load"])
        many = of_test[loads["nu"].transform("size") >= 3]  # groups of few cost time in large sweeps
        for (_, nu, load), group in many.groupby(["mesh", "nu", "load"]):
            group = group[group["stiffness-form"] != "E"].drop_duplicates("diagonal-ratio")
            group = group.sort_values("diagonal-ratio")
            if len(group) < 3:
                continue
            ratio = group["diagonal-ratio"].to_numpy(dtype=float)
            answer = group[measures.answer(test).column].to_numpy(dtype=float)
            base = answer[np.abs(np.log(ratio)).argmin()]
            lines.append(
                curves.Curve(
                    f"nu {nu:g}, {load}",
                    ratio,
                    answer / base,
                    list(group.status),
                    style={"color": shades(6)[len(lines) % 6], "marker": "o", "markersize": 3},
                )
            )
        if lines:
            name = measures.answer(test).label
            panels.append(curves.Panel(test, "A = k_f/k_c", f"{name}, over A = 1", lines, log_x=True))
    if not panels:
        return []
    caption = (
        "The ratio A of face to inner diagonals: the small-strain moduli do not know it, the "
        "answer at larger strain and on a finite mesh does."
    )
    return [Figure("diagonal_ratio", caption, curves.draw, (panels[:3],))]


def error_parts(study):
    """Law and discretisation, from the tables split and laws."""
    split, laws = study.tables.get("split"), study.tables.get("laws")
    if split is None and laws is None:
        return None
    section = Section("error-parts", "Where the errors come from")
    section.blocks.append(
        paragraph(
            "Law: what the springs' own continuum (Cauchy-Born) does otherwise than a law of finite "
            "elements. Discretisation: what springs on this mesh do otherwise than that continuum. "
            "Converged values carry error bounds and are shown to their digits."
        )
    )
    if split is not None:
        section.blocks += _both_parts(split) + table_blocks(split)
    if laws is not None:
        section.blocks += _law_parts(laws) + table_blocks(laws)
    return section


def _both_parts(document):
    panels, labels = [], []
    for quantity, title in (("volume_change", "Volume change"), (None, "Answer")):
        rows = [
            row
            for row in document["rows"]
            if (row["measure"] == quantity if quantity else row["measure"] in measures.answer_names())
            and row["scene"] != "uniaxial"
        ]
        by_label = {f"{row['scene']} {row['load']}": row for row in rows}
        labels = labels or list(by_label)
        percent = quantity is None
        columns = []
        for part in ("law", "discretisation"):
            columns += _parts(by_label, labels, part, percent)
        panels.append((title, "% of Hencky" if percent else _unit(rows), *columns))
    if not labels:
        return []
    caption = "The two parts of mss-cf's error, with the bounds of the converged values."
    return [Figure("error_parts", caption, error_figures.draw, (labels, panels))]


def _law_parts(document):
    """The law parts of the answers, where several methods bear one load on one mesh."""
    by_load = {}
    for row in document["rows"]:
        if row["measure"] in measures.answer_names() and row["law_percent"] is not None:
            by_load.setdefault((row["scene"], row["load"], row["cells"]), []).append(row)
    loads = {key: rows for key, rows in by_load.items() if len({row["method"] for row in rows}) > 1}
    if not loads:
        return []
    springs = []
    for rows in loads.values():
        springs += [(row["method"], row["reference_law"]) for row in rows]
    springs = list(dict.fromkeys(springs))
    panels = [
        (
            f"{scene} {load}",
            [
                (springs.index((row["method"], row["reference_law"])), row["nu"])
                + (abs(row["law_percent"]), row["law_percent_bar"])
                for row in rows
            ],
        )
        for (scene, load, _), rows in loads.items()
    ]
    names = [f"{method} from {reference}" for method, reference in springs]
    caption = (
        "How far the continuum of springs is from a law of finite elements, in large deformation: "
        "the law part of plate force, resultant force or torque. Hollow: within its bound, and drawn there; "
        "at the left edge what is smaller."
    )
    return [Figure("law_parts", caption, error_figures.draw_law_parts, (names, panels))]


def _unit(rows):
    return rows[0]["unit"] if rows else ""


def _parts(by_label, labels, part, percent):
    """Values and bars of a part by label; percent of the reference where `percent`."""
    values, bars = [], []
    for label in labels:
        row = by_label.get(label)
        value = None if row is None else row[f"{part}_percent" if percent else part]
        bar = None if row is None else row[f"{part}_bar"]
        if bar is not None and percent:
            bar = 100 * bar / abs(row["reference"])
        values.append(np.nan if value is None else value)
        bars.append(0 if bar is None else bar)
    return [np.array(values), np.array(bars)]


def locking(study):
    document = study.tables.get("locking")
    if document is None:
        return None
    lines = []
    for law in dict.fromkeys(row["law"] for row in document["rows"]):
        for element in dict.fromkeys(row["element"] for row in document["rows"]):
            rows = [r for r in document["rows"] if (r["law"], r["element"]) == (law, element)]
            rows = [r for r in rows if r["plate_force"] is not None]
            if not rows:
                continue
            x = np.array([0.5 - r["nu"] for r in rows])
            y = np.array([r["plate_force"] for r in rows])
            lines.append(
                curves.Curve(
                    f"{law}:{element}",
                    x,
                    y,
                )
            )
    panel = curves.Panel("", "1/2 − nu", measures.heading("plate_force"), lines, log_x=True, log_y=True)
    section = Section("locking", "Volumetric locking")
    caption = document["title"] + ". The volume change hardly shows it."
    section.blocks.append(Figure("locking", caption, curves.draw, ([panel],)))
    section.blocks += table_blocks(document)
    return section


def orientation(study):
    document = study.tables.get("orientation")
    if document is None:
        return None
    section = Section("orientation", "The lattice's directions")
    section.blocks += [paragraph("{}.", document["title"]), *table_blocks(document)]
    return section


def modes(study):
    document = study.tables.get("modes")
    if document is None:
        return None
    section = Section("modes", "Natural frequencies")
    section.blocks.append(paragraph("{}.", document["title"]))
    panels = [
        _off_elements(document, body)
        for body in dict.fromkeys(row["body"] for row in document["rows"])
    ]
    styles = {name: line(name) for name in _SWINGING.values()}
    styles["lumped FEM"] = {"color": NEUTRAL[1], "marker": "x", "markersize": 4}
    styles["nodal FEM"] = {"color": NEUTRAL[1], "marker": "+", "markersize": 5}
    caption = (
        "Frequencies off finite elements with consistent masses, at nu = 0.25. Lumped FEM has the "
        "springs' own masses: what springs differ by from it is stiffness."
    )
    section.blocks += [Figure("modes", caption, row_figures.draw, (panels, styles)), *table_blocks(document)]
    return section


# Columns of the table modes by the names they have in figures.
_SWINGING = {
    "lumped": "lumped FEM",
    "nodal": "nodal FEM",
    "cf": "mss-cf",
    "affine": "mss-affine",
    "nfd": "mss-nfd",
}


def _off_elements(document, body):
    rows = [row for row in document["rows"] if (row["body"], row["nu"]) == (body, 0.25)]
    labels = [f"{row['modes']} {row['motion'] or ''}" for row in rows]
    series = {  # none of what is refused there, or came after the table was stored
        name: np.array([row[f"{key}_off"] for row in rows], dtype=float)
        for key, name in _SWINGING.items()
        if any(row.get(f"{key}_off") is not None for row in rows)
    }
    return body.capitalize(), labels, "frequency off finite elements [%]", series
