"""Limits of the equilibrium path: where bodies lose their stability, beside theory."""

import measures
import methods
import numpy as np
from case_words import case_text, mesh_text, method_name
from content import Figure, Section, paragraph, table
from figures import curves
from markupsafe import Markup
from method_style import line
from numbers_shown import data, significant

_MOST_ROWS = 200

def stability_limits(study):
    if study.limits.empty:
        return None
    section = Section("stability-limits", "Limits of stability")
    section.blocks.append(
        paragraph(
            "The static path from rest, followed through stable states alone to the first that is "
            "not: found by bisection of the load to 0.2 %. The mode that becomes unstable there "
            "tells by its wavelength, in edges between nodes, whether a body wrinkles (below 4) or buckles."
        )
    )
    section.blocks += _figures(study)
    section.blocks.append(_table(study))
    return section


def _figures(study):
    """For each test the mesh with most limits, over nu."""
    figures = []
    for test, cases in study.limits.groupby("test", sort=False):
        cases = cases[cases.mesh == cases.mesh.mode()[0]]
        if cases.nu.nunique() < 3:
            continue
        drawn = [
            _curve(name, of_name.sort_values("nu"))
            for name, of_name in cases.groupby(cases.apply(_name, axis=1), sort=False)
        ]
        drawn = [curve for curve in drawn if np.isfinite(curve.y).any()]
        if not drawn:
            continue  # all paths held
        if test == "compression":
            drawn += _theory(study, set(cases.method))
        label = "angle [°]" if measures.turns(test) else "deformation [%]"
        caption = (
            f"Where the path ends in {test}, {mesh_text(cases.iloc[0])}. Methods without a marker "
            "held to the largest load that was tried. Dashed: the infinite lattice in uniaxial "
            "compression, by its plane waves, which no glued plate holds."
        )
        panel = curves.Panel(f"Limit in {test}", study.settings["nu"]["label"], label, drawn, from_zero=True)
        figures.append(Figure(f"limits_{test}", caption, curves.draw, ([panel],)))
    return figures


def _name(case):
    name = method_name(case.drop("solver"))
    return f"{name}, {case.further}" if case.further else name


def _curve(name, cases):
    reached = cases.definite_up_to_deformation.abs().to_numpy(dtype=float)
    return curves.Curve(name, cases.nu.to_numpy(dtype=float), reached * _scale(cases.iloc[0]))


def _scale(case):
    return np.degrees(1) if measures.turns(case.test) else 100


def _theory(study, names):
    document = study.tables.get("lattice-stability")
    if document is None:
        return []
    found = []
    for method in sorted(names):
        rows = [row for row in document["rows"] if row["method"] == method and row["compression_strain"] is not None]
        if methods.reads(method, "diagonal-ratio"):  # others have one
            usual = float(methods.default("diagonal-ratio"))
            rows = [row for row in rows if row["diagonal_ratio"] == usual]
        if not rows:
            continue
        style = line(method) | {"linestyle": "--", "marker": ""}
        x, y = (np.array([row[key] for row in rows], dtype=float) for key in ("nu", "compression_strain"))
        found.append(curves.Curve(f"{method}, infinite lattice", x, y, style=style))
    return found


def _table(study):
    rows = []
    for key, case in study.limits.sort_values(["test", "method", "nu"]).iterrows():
        limit = _number(case, key, "definite_up_to_deformation", _scale(case), 4)
        mode = _number(case, key, "critical_wavelength", 1, 3)
        rows.append([_name(case), case_text(case), limit, measures.said(case.status), mode, (key[:8], "key")])
    heads = ["method", "case, tried up to", "limit [%, °]", "there it", "mode [edges]", "case's key"]
    return Markup("<h3>All limits</h3>") + table(heads, rows, name="stability-limits", limit=_MOST_ROWS)


def _number(case, key, measure, scale, digits):
    value = abs(float(case[measure]))
    if not np.isfinite(value):
        return ""
    return Markup(data(float(case[measure]), significant(scale * value, digits), key, measure))
