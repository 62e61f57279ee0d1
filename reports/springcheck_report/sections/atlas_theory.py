"""What theory says of the limits in a map of the stability atlas."""

from dataclasses import dataclass

import methods
import numpy as np
from figures.failure_maps import Line

_COLUMNS = {"nu": "nu", "diagonal-ratio": "diagonal_ratio"}  # of the table, by setting
_LOADS = {"compression": ["compression"], "tension": ["tension"], "uniaxial": ["compression", "tension"]}
_LATTICE_WORDS = (
    "Infinite lattice: the strain at which the infinite regular lattice in uniaxial stress loses its first "
    "plane wave or its free sides (table lattice-stability); glued plates hold waves off, free "
    "surfaces let them in earlier."
)
_STEP = "largest step of linear theory"
_STEP_WORDS = (
    "Largest step of linear theory: ratio 1, which is 2/ω_max without damping, ω_max the largest "
    "frequency of the body's tangent (dynamics/marching/stable_step.hpp)."
)


@dataclass
class Theory(Line):
    """source: what the line is and where it comes from, a sentence for captions."""

    source: str


def theory_on(study, one, method, edges):
    """Lines over the map of a method. edges: of the fields along the second axis."""
    first, second = one["axes"]
    if first["numbers"] is None:
        return []
    if first["key"] == "dt-ratio":
        return _within(first, _level(_STEP, edges, 1, _STEP_WORDS))
    if second["key"] == "dt-ratio" and second["numbers"]:
        ends = np.array([first["numbers"][0], first["numbers"][-1]], dtype=float)
        is_inside = second["numbers"][0] <= 1 <= second["numbers"][-1]
        return [Theory(_STEP, np.ones(2), ends, _STEP_WORDS)] if is_inside else []
    case = _case_of(study, one, method)
    if first["key"] != "deformation" or case is None:
        return []
    return _bar(first, case, edges) + _lattice(study, one, method, case, edges)


def _bar(first, case, edges):
    """Where a bar of the method's law bears its largest force."""
    limit, words = methods.bar_limit(case.method)
    if not limit or case.test not in ("compression", "uniaxial"):
        return []
    name = f"{methods.law(case.method)}'s bar"
    strain = _scale(first, case, "compression") * limit
    return _within(first, _level(name, edges, strain, f"{name}: {100 * limit:.1f} %, {words}."))


def _case_of(study, one, method):
    """The first case of the method that the file has."""
    cases = (study.case(p["case"]) for p in one["points"] if p["method"] == method and p["failure"])
    return next((case for case in cases if case is not None), None)


def _level(label, edges, y, source):
    """A line across the whole map."""
    return Theory(label, np.array([edges[0], edges[-1]], dtype=float), np.full(2, float(y)), source)


def _scale(first, case, load):
    """Of a strain's size in the axis's unit. In uniaxial compression is negative."""
    size = 100 if first["unit"] == "%" else 1
    return -size if case.test == "uniaxial" and load == "compression" else size


def _within(first, line):
    """The line, unless it is off the map altogether."""
    low, high = first["numbers"][0], first["numbers"][-1]
    inside = np.isfinite(line.y) & (line.y >= low) & (line.y <= high)
    return [line] if inside.any() else []


def _lattice(study, one, method, case, edges):
    """The infinite lattice's first loss of stability over the second axis, from the table
    lattice-stability."""
    document = study.tables.get("lattice-stability")
    if document is None or case["cell-type"] != "hexahedron":
        return []
    first, second = one["axes"]
    own = {"nu": case.nu}
    if methods.reads(method, "diagonal-ratio"):  # others have one
        own["diagonal-ratio"] = case["diagonal-ratio"]
    along = second["key"] if second["key"] in own else None
    if along and second["numbers"] is None:
        return []  # its values do not stand where they are
    rows = [
        row
        for row in document["rows"]
        if row["method"] == method
        and all(np.isclose(row[_COLUMNS[key]], value) for key, value in own.items() if key != along)
    ]
    lines = []
    for load in _LOADS.get(case.test, []):
        lost = [row for row in rows if row[f"{load}_strain"] is not None]  # percent
        if not lost:
            continue
        strains = _scale(first, case, load) / 100 * np.array([row[f"{load}_strain"] for row in lost])
        if along:
            x = np.array([row[_COLUMNS[along]] for row in lost], dtype=float)
            lines += _within(first, Theory("infinite lattice", x, strains, _LATTICE_WORDS))
        else:
            lines += _within(first, _level("infinite lattice", edges, strains[0], _LATTICE_WORDS))
    return lines
