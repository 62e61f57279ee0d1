"""Up to which deformation methods hold, over another setting."""

import numpy as np
from content import Answer, Figure
from figures import curves
from markupsafe import Markup
from sections.answers.words import SIZE, TESTS, bold, case_number
from sections.atlas import axis_label, case_of_map, conditions


def first_failures(study):
    """Of the first map whose first axis is a deformation and whose second is of numbers."""
    for one in study.atlas.get("maps", []):
        axes = one["axes"]
        if len(axes) == 2 and axes[0]["key"] == "deformation" and axes[1]["numbers"] and one["limits"]:
            return _answer(study, one)
    return None


def _answer(study, one):
    first, second = one["axes"]
    case = case_of_map(study, one)
    numbers = dict(zip(second["values"], second["numbers"]))
    by_method = {}
    for limit in one["limits"]:
        by_method.setdefault(limit["method"], []).append(limit)
    lines = [_curve(method, limits, numbers) for method, limits in by_method.items()]
    labels = [axis_label(axis, case, study.settings) for axis in (second, first)]
    panel = curves.Panel("", labels[0], f"holds up to: {labels[1]}", lines, from_zero=True)
    caption = (
        f"{conditions(one, case)} The curves are the {first['key']} up to which a method holds; it is the "
        "map's largest where nothing failed in it."
    )
    unit = f" {first['unit']}" if first["unit"] else ""
    parts = [_least(method, limits, first, unit) for method, limits in by_method.items()]
    done = TESTS[case.test].removesuffix(" by {}")
    sentence = Markup("{} further and further, at every {} from {} to {}: {}.").format(
        done, study.settings[second["key"]]["label"], second["values"][0], second["values"][-1], Markup(", ").join(parts)
    )
    figure = Figure("answer_limits", caption, curves.draw, ([panel], SIZE, 3))
    return Answer("Where do they fail?", figure, sentence, "atlas")


def _curve(method, limits, numbers):
    limits = sorted(limits, key=lambda limit: numbers[limit["other"]])
    x = np.array([numbers[limit["other"]] for limit in limits], dtype=float)
    return curves.Curve(method, x, np.array([limit["low"] or 0 for limit in limits], dtype=float))


def _least(method, limits, first, unit):
    """"mss-cf holds up to 36 %"; "at least 60 %" where nothing failed."""
    weakest = min(limits, key=lambda limit: limit["low"] or 0)
    if weakest["low"] is None:
        return Markup("{} holds nowhere").format(bold(method))
    words = "holds up to" if weakest["high"] is not None else "holds at least up to"
    return Markup("{} {} {}{}").format(bold(method), words, case_number(weakest["low"], weakest["case"]), unit)
