"""Dynamics: what the protocol alone changes, solvers beside statics, histories."""

import measures
import methods
import numpy as np
from case_words import case_text, method_name
from content import Figure, Section, document_blocks, measured_number, paragraph, table, tabled_number
from figures import rows as row_figures
from markupsafe import Markup
from method_style import colour
from numbers_shown import formatted
from sections.histories import histories
from study import USABLE, is_through_time

_MOST_ROWS = 200


def through_time(study):
    blocks = [*_protocols(study), *_solvers(study), *histories(study)]
    if not blocks:
        return None
    section = Section("through-time", "Through time")
    section.blocks.append(
        paragraph(
            "Elsewhere on this page springs are in equilibrium, unless their name says a solver. Here "
            "plates move at constant velocity for a given time, or along a path of such pieces, and the "
            "figure is read at its end, as the thesis did. How near that is to rest depends on how often "
            "a pressure wave has run through the body meanwhile (transits) and on the damping; the "
            "kinetic energy left, over the strain energy, tells."
        )
    )
    section.blocks += blocks
    return section


def _protocols(study):
    """The table dynamics."""
    document = study.tables.get("dynamics")
    if document is None:
        return []
    caption = (
        "Mss-cf's figures as printed and from dynamics, off our static equilibria. Dynamics in SI "
        "units ends at rest: it stands on zero. In raw units, centimetres read as metres, the "
        "figure is read while undamped waves still run. A row without dots has no "
        "equilibrium. Linear within ±0.1."
    )
    figure = Figure("protocols", caption, row_figures.draw, (_panels(document), _series(), 0.1))
    heads = ["test", "nu", "deformation", "measure", "printed", "static"]
    for key, units in (("dynamic", "SI"), ("raw", "raw")):
        damping = ", ".join(f"{value:g}" for value in sorted({r[f"{key}_damping"] for r in document["rows"]}))
        heads += [f"{units} units, damping {damping}", "off statics [points, %]"]
        heads += ["transits", "kinetic/strain energy"]
    rows = [_protocol_row(study, document, row) for row in document["rows"]]
    title = Markup("<h3>{}</h3>").format(document["title"])
    return [title, figure, *document_blocks(document, heads, rows)]


def _series():
    own = colour(methods.of_thesis())
    return {
        "printed": {"marker": "x", "color": "black", "markersize": 4.5},
        "dynamics, SI units": {"marker": "o", "color": own, "markersize": 3.5},
        "dynamics, raw units": {"marker": "D", "color": own, "markersize": 4, "mfc": "white"},
    }


def _panels(document):
    """Volume changes in points, forces and torques in percent."""
    panels = []
    volumes = [row for row in document["rows"] if _is_percent(row)]
    others = [row for row in document["rows"] if not _is_percent(row)]
    for title, rows, unit in (("Volume change", volumes, "points"), ("Force and torque", others, "%")):
        if not rows:
            continue
        labels = [
            f"{row['test']} {row['deformation'].replace(' deg', '°')}, ν = {row['nu']:g}" for row in rows
        ]
        values = [
            np.array([_off_statics(row, key) for row in rows], dtype=float)
            for key in ("printed", "dynamic", "raw")
        ]
        panels.append((title, labels, f"off statics [{unit}]", dict(zip(_series(), values))))
    return panels


def _is_percent(row):
    return row["unit"] == "%"


def _off_statics(row, key):
    """Points of a volume change, percent of anything else; None where either is lacking."""
    if row[key] is None or row["static"] is None:
        return None
    difference = row[key] - row["static"]
    return difference if _is_percent(row) else 100 * difference / row["static"]


def _protocol_row(study, document, row):
    still, moved, raw = row["cases"]
    formats = {column["key"]: column["format"] for column in document["columns"]}

    def number(key, case=None):
        text = "" if row[key] is None else formatted(row[key], formats[key])
        return tabled_number(document, row[key], text, case) if text else ""

    def off_statics(key, case):
        value = _off_statics(row, key)
        return "" if value is None else tabled_number(document, value, formatted(value, "{:+.3f}"), case)

    cells = [row["test"], number("nu"), row["deformation"], row["measure"], number("printed")]
    cells.append(number("static", still) or _status_cell(study, still))
    for key, case in (("dynamic", moved), ("raw", raw)):
        cells += [number(key, case) or _status_cell(study, case), off_statics(key, case)]
        cells += [number(f"{key}_transits", case), number(f"{key}_kinetic", case)]
    return cells


def _status_cell(study, case):
    """Why there is no number."""
    if case not in study.cases.index:
        return ""
    return study.cases.loc[case, "status"].replace("_", " "), "failed"


def _solvers(study):
    """Every case through time beside the static equilibrium of the same springs, but those
    of the table dynamics."""
    document = study.tables.get("dynamics", {"rows": []})
    shown = {case for row in document["rows"] for case in row["cases"]}
    cases = study.distinct[study.distinct.apply(is_through_time, axis=1)]
    cases = cases[~cases.index.isin(shown) & cases.test.isin(measures.answers()) & (cases.status != "refused")]
    if cases.empty:
        return []
    statics = _statics(study)
    order = ["scene", "mesh", "nu", "deformation", "method", "solver", "damping"]
    rows = [_solver_row(study, key, statics) for key in cases.sort_values(order, kind="stable").index]
    heads = ["case", "method", "solver", "at the end", "statics", "off statics [%]", "kinetic/strain energy"]
    heads += ["damping", "transits", "duration [s]", "steps", "precision", "key"]
    note = paragraph(
        '<span class="note">At the end: force or torque on the plate, of beams the tip deflection. '
        "Statics are of the same springs, or of the same elements at rest, on the same problem: of "
        "fem-explicit-8p those of fem-stvk:q1, of fem-explicit-hencky those of fem-hencky.</span>"
    )
    title = Markup("<h3>Solvers through time beside statics</h3>")
    return [title, table(heads, rows, name="solvers", limit=_MOST_ROWS), note]


def _statics(study):
    """Keys of static equilibria by problem and name."""
    cases = study.cases[(study.cases.solver == "static") & (study.cases.status == USABLE)]
    return {(case.problem, case["name"]): key for key, case in cases.iterrows()}


def _solver_row(study, key, statics):
    case = study.cases.loc[key]
    measure, _, unit = measures.answer(case.test)

    def number(name, form, of=key):
        value = study.cases.loc[of, name]
        return measured_number(study, of, name, formatted(value, form)) if np.isfinite(value) else ""

    plain = method_name(case.drop("solver"))
    other = statics.get((case.problem, methods.at_rest(plain)))
    still = off = ""
    if other is not None and np.isfinite(case[measure]):
        still = number(measure, "{:.5g}", other)
        off = formatted(100 * (case[measure] / study.cases.loc[other, measure] - 1), "{:+.3f}")
    end = number(measure, f"{{:.5g}} {unit}") or _status_cell(study, key)
    energies = case.kinetic_energy / case.strain_energy if case.strain_energy > 0 else np.nan
    return [
        *(case_text(case), plain, case.solver, end, still, off),
        formatted(energies, "{:.1e}") if np.isfinite(energies) else "",
        *(number("damping", "{:g}"), number("transit_count", "{:.1f}"), number("duration", "{:g}")),
        *(number("steps", "{:.0f}"), case.precision or "", (key[:8], "key")),
    ]
