"""Force and energies on the way through time, of cases that stored a history."""

import json

import measures
import numpy as np
from case_words import case_text, counts_text, is_variant, method_name
from content import Figure
from figures import curves
from method_style import colour, shades

_MOST_CURVES = 8
_DASHES = ["-", "--", ":", "-."]
# What forces and torques on bodies of different size are divided by, by their unit.
_SCALES = {"N": "E A", "N m": "E V"}


def histories(study):
    """For each test a figure of the problem with the most histories, of nu nearest 1/4."""
    cases = study.cases[[study.has(key, "history") for key in study.cases.index]]
    figures = []
    for test, of_test in cases.groupby("test", sort=False):
        groups = [group for _, group in of_test.groupby(of_test.apply(_shape, axis=1), sort=False)]
        best = min(
            groups, key=lambda group: (-len(group), abs(group.nu.iloc[0] - 0.25), -group.strain.max())
        )
        figures.append(_figure(study, f"history_{test}", best, len(of_test)))
    return figures


def _shape(case):
    """What bodies of different size share that are deformed alike: blocks of the thesis are
    a hundred times larger in its raw units."""
    if case.body != "block" or not np.isfinite(case.whole_deformation):
        return case.whole_problem
    sides = [round(case[f"size.{axis}"] / case["size.z"], 9) for axis in "xy"]
    settings = [case["cell-type"], case.get("distortion", 0), case.nu, case.whole_deformation]
    return json.dumps([counts_text(case), sides, *settings])


def _figure(study, name, cases, of_test):
    """Over E and the size where bodies differ in them, so that one equilibrium is one."""
    group = cases.sort_values(["scene", "method", "solver", "damping"]).iloc[:_MOST_CURVES]
    test, is_scaled = group.test.iloc[0], group.whole_problem.nunique() > 1
    answers, strain, ratio = [], [], []
    for (key, case), style in zip(group.iterrows(), _styles(group)):
        history = study.history(key)
        label, time = _label(case, group), history.time.to_numpy()
        answer_unit, energy_unit = _units(case) if is_scaled else (1, 1e-3)
        if "answer" in history and history.answer.notna().any():  # files of before 0.3.0 have none
            answers.append(curves.Curve(label, time, history.answer.to_numpy() / answer_unit, style=style))
        energy = history.strain_energy.to_numpy()
        with np.errstate(divide="ignore", invalid="ignore"):
            share = history.kinetic_energy.to_numpy() / energy
        strain.append(curves.Curve(label, time, energy / energy_unit, style=style))
        if np.any(share > 0):  # without inertia there is none
            ratio.append(curves.Curve(label, time, share, style=style))
    energy_label = "energy / (E V)" if is_scaled else "energy [mJ]"
    panels = [curves.Panel("Strain energy", "time [s]", energy_label, strain)]
    if ratio:
        panels.append(curves.Panel("Kinetic over strain energy", "time [s]", "ratio", ratio, log_y=True))
    if answers:
        measure = measures.answer_name(test)
        label, unit = measures.label(measure), measures.unit(measure)
        y_label = f"{label} / ({_SCALES[unit]})" if is_scaled else f"{label} [{unit}]"
        answers += _statics(study, group, is_scaled)
        panels.insert(0, curves.Panel(label.capitalize(), "time [s]", y_label, answers))
    first = group.iloc[0].copy()
    first["load"] = first.whole_load
    text = case_text(first).removeprefix(f"{first.scene}, ")
    caption = f"On the way through time: {test}, {text}. Hollow rings are bodies at rest under the last load."
    if is_scaled:
        caption += " Bodies of different size, over Young's modulus and section (A) or volume (V)."
    if of_test > len(group):
        caption += f" {len(group)} of the {of_test} histories of this test in the result file."
    return Figure(name, caption, curves.draw, (panels,))


def _units(case):
    """What the answer and the energy are divided by, see _SCALES: the energy by E V."""
    area = case["size.x"] * case["size.y"]
    scales = {"E A": case.young * area, "E V": case.young * area * case["size.z"]}
    return scales[_SCALES[measures.unit(measures.answer_name(case.test))]], scales["E V"]


def _styles(group):
    """A colour for each method and dashes for its cases; of one method alone a colour for
    each case."""
    if group.method.nunique() == 1:
        darker = shades(len(group) + 1)[:-1]  # the last is pale on white
        return [{"color": shade, "linewidth": 1.1} for shade in darker]
    places = group.groupby("method").cumcount()
    return [
        {"color": colour(method), "linestyle": _DASHES[place % len(_DASHES)], "linewidth": 1.1}
        for method, place in zip(group.method, places)
    ]


def _label(case, group):
    """Method and solver, and what else the cases differ in."""
    label = method_name(case.drop("solver"))
    if case.solver != "static" or group.solver.nunique() > 1:
        label += f", {case.solver}"
    label += "".join(f", {part}" for part in _own_parts(case, group))
    if group.scene.nunique() > 1:
        label = f"{case.scene}: {label}"
    if group.load.nunique() > 1:
        label += f", {case.load}"
    if group.damping.nunique() > 1:
        label += f", damping {case.damping:g}"
    return f"{label}, single precision" if case.precision == "float" else label


def _own_parts(case, group):
    """Of the settings that tell cases apart (Study.cases.further), those that not all here share."""
    parts = group.further.str.split(", ")
    return [part for part in case.further.split(", ") if part and not all(part in other for other in parts)]


def _statics(study, group, is_scaled):
    """Equilibria of the same methods on the same problems, at the end of time."""
    same = study.cases[study.cases.problem.isin(group.problem) & study.cases.method.isin(group.method)]
    same = same[(same.solver == "static") & (same.status == "ok") & ~same.is_repeated]
    same = same[~same["name"].map(is_variant) & ~same.index.isin(group.index)]
    found = []
    for _, case in same.iterrows():
        moved = group[group.problem == case.problem]
        end = np.array([moved.duration.max()])
        ring = {"linestyle": "none", "marker": "o", "markersize": 5, "markerfacecolor": "none"}
        ring["color"] = colour(case["name"])
        answer = np.array([case.answer / (_units(case)[0] if is_scaled else 1)])
        if measures.answer_name(case.test) == "plate_force":  # it is positive whichever way a path has gone
            answer *= np.sign(case.deformation * moved.whole_deformation.iloc[0])
        found.append(curves.Curve(f"{case['name']} at rest", end, answer, style=ring))
    return found
