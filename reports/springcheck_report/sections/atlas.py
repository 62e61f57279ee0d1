"""The stability atlas: maps of how methods fail over two settings."""

import measures
import numpy as np
from case_words import counts_text, load_text, mesh_text
from content import Figure, Section, file_name, paragraph, table
from figures import failure_maps
from markupsafe import Markup
from numbers_shown import data, revision_text, significant
from sections.atlas_theory import theory_on

_MOST_MAPS = 24
_MOST_ROWS = 120
# From here on the values of an axis that are spaced more evenly by their logarithms are drawn so.
_LEAST_SPAN_OF_LOGARITHMS = 20


def atlas(study):
    """Of the maps with at least one case; of a single setting none: there the limit says all."""
    maps = [m for m in study.atlas.get("maps", []) if len(m["axes"]) == 2 and _is_begun(m)]
    if not maps:
        return None
    section = Section("atlas", "Stability atlas")
    letters = {kind["name"]: kind["letter"] for kind in study.atlas["failures"]}
    section.blocks.append(
        paragraph(
            "How each method fails over two settings, a field for every simulation. Wrinkling: a "
            "free face zigzags from cell to cell. Hourglassing: cells inside alternate in modes "
            "that their mean deformation does not see. Loss of definiteness: an equilibrium that is no "
            "minimum of the energy. Limit point: no equilibrium beyond some part of the load. "
            "Inversion: a cell turned inside out. Blow-up: a motion that left all bounds. Locking: "
            "a plate force more than 10 % above that of the same law on elements that do not lock. "
            "Solver failure and 'not covered', a method that refuses the scene, say nothing of the "
            "body; beyond a limit of the path a field may show another stable state. Definitions are in "
            "<code>comparisons/stability/failure.hpp</code>; fields and limits as numbers in "
            '<a href="data/atlas.json">data/atlas.json</a>.'
        )
    )
    names = []
    for one in maps[:_MOST_MAPS]:
        section.blocks += _blocks(study, one, letters, names)
    if len(maps) > _MOST_MAPS:
        section.blocks.append(paragraph("{} further maps are in data/atlas.json.", len(maps) - _MOST_MAPS))
    return section


def _is_begun(one):
    return any(point["failure"] for point in one["points"])


def _blocks(study, one, letters, names):
    """Heading, figure, the map in letters and the table of limits."""
    first, second = one["axes"]
    name = _new_name("_".join(["atlas", file_name(one["scene"]), first["key"], second["key"]]), names)
    case = case_of_map(study, one)
    vertical, horizontal = (_axis(axis, case, study.settings) for axis in one["axes"])
    panels = [
        failure_maps.Panel(
            method,
            _failures(one, method),
            _limit_line(one, method, horizontal),
            theory_on(study, one, method, horizontal.edges()),
        )
        for method in _methods(one)
    ]
    heading = Markup("<h3>{}: {} against {}</h3>").format(one["scene"], first["key"], second["key"])
    words = [conditions(one, case), *_revision_words(one), *_limit_words(panels, first), *_theory_words(panels), *_progress(one)]
    figure = Figure(name, " ".join(words), failure_maps.draw, (vertical, horizontal, panels, letters))
    blocks = [heading, *_how_to_refine(study, one, case), figure, *_limits_table(study, one, name)]
    return [*blocks, _in_letters(one, letters)]


def case_of_map(study, one):
    """Some case of a map that has been begun."""
    return next(c for c in (study.case(p["case"]) for p in one["points"] if p["failure"]) if c is not None)


def _how_to_refine(study, one, case):
    """Of a map over fewer values than its settings usually have: how one over those is made."""
    if not any(len(axis["values"]) < _usual_count(study, axis["key"]) for axis in one["axes"]):
        return []
    keys = [axis["key"] for axis in one["axes"]]
    cells = "" if "cells" in keys or case.body != "block" else f" --cells {counts_text(case).replace('×', ',')}"
    return [
        paragraph(
            "A quick map, of {} fields for each method. <code>springcheck stability {} --method {}{} --over {} --out "
            "{}</code>, with what else the caption names where that is not the scene's, adds one of {}.",
            " × ".join(str(len(axis["values"])) for axis in one["axes"]),
            one["scene"],
            ",".join(_methods(one)),
            cells,
            ",".join(keys),
            study.results.path.name,
            " × ".join(str(_usual_count(study, key) or len(axis["values"])) for key, axis in zip(keys, one["axes"])),
        )
    ]


def _usual_count(study, key):
    """0: nobody goes over it without saying by which values."""
    usual = study.settings[key]["usual_axis"]
    if ":" in usual:
        return int(usual.rpartition(":")[2])
    return len(usual.split(",")) if usual else 0


def _revision_words(one):
    others = one["other_revisions"]
    return [f"Made with the numerics of {revision_text(others)}, not this program's."] if others else []


def _new_name(name, names):
    """The name, with a number where a map of the same settings has it already."""
    count = 1 + sum(other.split(".")[0] == name for other in names)
    names.append(name if count == 1 else f"{name}.{count}")
    return names[-1]


def _methods(one):
    return list(dict.fromkeys(point["method"] for point in one["points"]))


def _axis(axis, case, settings):
    """Numbers that ascend stand where they are, other values one beside the other."""
    label = axis_label(axis, case, settings)
    if axis["numbers"] is None:
        return failure_maps.Axis(label, np.arange(len(axis["values"]), dtype=float), texts=axis["values"])
    return failure_maps.Axis(label, np.array(axis["numbers"], dtype=float), _is_logarithmic(axis["numbers"]))


def _is_logarithmic(numbers):
    at = np.array(numbers, dtype=float)
    if at[0] <= 0 or at[-1] < _LEAST_SPAN_OF_LOGARITHMS * at[0] or len(at) < 3:
        return False

    def unevenness(places):
        return np.std(np.diff(places)) / np.mean(np.diff(places))

    return bool(unevenness(np.log(at)) < unevenness(at))


def axis_label(axis, case, settings):
    key, unit = axis["key"], axis["unit"]
    if key != "deformation":
        label = settings[key]["label"]
        unit = (unit or settings[key]["si_unit"]).replace("^3", "³").replace("^2", "²")
        return label if settings[key]["kind"] == "string" or settings[key]["most"] != 1 else f"{label} [{unit}]"
    if measures.turns(case.test):
        return "angle of torsion [°]" if unit == "deg" else "angle of torsion [rad]"
    return "deformation [%]" if unit == "%" else "deformation [-]"


def _failures(one, method):
    """[value of the first axis][value of the second]."""
    found = {tuple(p["values"]): p["failure"] for p in one["points"] if p["method"] == method}
    first, second = (axis["values"] for axis in one["axes"])
    return [[found.get((a, b)) for b in second] for a in first]


def _limits_of(one, method):
    """Those that lie between two values of the first axis, by the value of the second."""
    return {
        limit["other"]: limit
        for limit in one["limits"]
        if limit["method"] == method and limit["low"] is not None and limit["high"] is not None
    }


def _limit_line(one, method, horizontal):
    limits = _limits_of(one, method)
    if not limits:
        return None
    values = one["axes"][1]["values"]
    y = np.array([limits[value]["low"] if value in limits else np.nan for value in values])
    return failure_maps.Line("limit", horizontal.positions, y)


def conditions(one, case):
    """What all fields of a map have in common, as far as it is no axis of it."""
    keys = {axis["key"] for axis in one["axes"]}
    parts = []
    if not keys & {"cells", "cell-type", "distortion", "mesh"}:
        parts.append(mesh_text(case))
    elif "distortion" in keys:
        parts.append(mesh_text(case.drop("distortion")))
    if "nu" not in keys:
        parts.append(f"nu {case.nu:g}")
    if "deformation" not in keys and load_text(case):
        parts.append(f"deformed by {load_text(case)}" if np.isfinite(case.deformation) else load_text(case))
    if case.solver and case.solver != "static" and "solver" not in keys:
        parts.append(f"stepped by {case.solver}" if case.solver != "limit" else "the path's limit")
        if "damping" not in keys and np.isfinite(case.damping):
            parts.append(f"damping {case.damping:g}")
        if "duration" not in keys and np.isfinite(case.duration):
            parts.append(f"in {case.duration:g} s")
    return f"How methods fail in {one['scene']}: {', '.join(parts)}."


def _limit_words(panels, first):
    if not any(panel.limit for panel in panels):
        return []
    if first["key"] == "deformation":
        return [
            "The line ends what holds: the path from rest is stable up to there (followed to 0.2 % of "
            "the load), or simulations were bisected to 1 %. It is broken where nothing fails, or "
            "all does."
        ]
    return [
        f"The line is the largest {first['key']} that holds, simulations bisected to 1 %; it is broken "
        "where nothing fails, or all does."
    ]


def _theory_words(panels):
    return list(dict.fromkeys(line.source for panel in panels for line in panel.theory))


def _progress(one):
    done = sum(point["failure"] is not None for point in one["points"])
    if done == len(one["points"]):
        return []
    return [
        f"Interrupted: {done} of {len(one['points'])} simulations are there; the same command computes "
        "the others."
    ]


def _limits_table(study, one, name):
    if not one["limits"]:
        return []
    first, second = one["axes"]
    unit = f" [{first['unit']}]" if first["unit"] else ""
    rows = []
    for limit in one["limits"]:
        bounds = [_number(limit["low"]), _number(limit["high"])]
        key = limit["case"]
        place = [limit["method"], limit["other"]]
        rows.append([*place, *bounds, limit["failure"], _mode(study, key), ((key or "")[:8], "key")])
    heads = ["method", second["key"], f"holds at {first['key']}{unit}", f"fails at{unit}", "by"]
    heads += ["mode [edges]", "case's key"]
    return [table(heads, rows, name=f"limits-{name}", limit=_MOST_ROWS)]


def _number(value):
    return "none" if value is None else Markup(data(value, significant(value, 5)))


def _mode(study, key):
    case = None if key is None else study.case(key)
    if case is None or not np.isfinite(case.critical_wavelength):
        return ""
    length = float(case.critical_wavelength)
    return Markup(data(length, significant(length, 3), key, "critical_wavelength"))


def _in_letters(one, letters):
    """The same map for readers without colours and for programs that read pages aloud: the
    first axis upwards, as `springcheck stability` prints it."""
    first, second = one["axes"]
    width = max(len(value) for value in first["values"])
    parts = []
    for method in _methods(one):
        lines = [
            f"{value:>{width}}  {' '.join(letters.get(failure, ' ') for failure in row)}"
            for value, row in zip(first["values"], _failures(one, method))
        ]
        parts.append(
            Markup('<pre data-method="{}">{}</pre>').format(
                method, f"{method}: {first['key']} against {second['key']}\n" + "\n".join(reversed(lines))
            )
        )
    across = f"{second['key']} from left to right: {', '.join(second['values'])}."
    words = [f"{letter} {name}" for name, letter in letters.items()]
    html = "<details><summary>The map in letters</summary>{}<p class=note>{} {}.</p></details>"
    return Markup(html).format(Markup("").join(parts), across, ", ".join(words))
