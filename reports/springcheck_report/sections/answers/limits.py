"""Up to which deformation methods stay stable, over another setting."""

import measures
import numpy as np
from case_words import mesh_text
from content import Answer, Figure
from figures import curves
from markupsafe import Markup
from method_style import NEUTRAL
from sections.answers.words import SIZE, bold, case_number
from sections.atlas import axis_label, case_of_map, conditions

_NO_LIMITS = ("not covered", "solver failure")  # which say nothing of the body


def first_failures(study):
    """Of the first map of a growing deformation over a setting of ascending numbers."""
    for one in study.atlas.get("maps", []):
        if len(one["axes"]) != 2:
            continue
        first, second = one["axes"]
        if first["key"] == "deformation" and first["numbers"] and first["numbers"][0] > 0 and second["numbers"]:
            by_method = {}
            for limit in one["limits"]:
                if limit["failure"] not in _NO_LIMITS:
                    by_method.setdefault(limit["method"], []).append(limit)
            if by_method:
                return _answer(study, one, by_method)
    return None


def _answer(study, one, by_method):
    first, second = one["axes"]
    case = case_of_map(study, one)
    numbers = dict(zip(second["values"], second["numbers"]))
    lines = [_curve(method, limits, numbers) for method, limits in by_method.items()]
    ends = np.array([min(second["numbers"]), max(second["numbers"])], dtype=float)
    style = {"color": NEUTRAL[1], "linestyle": ":", "linewidth": 0.8}
    lines.append(curves.Curve("largest that was tried", ends, np.full(2, max(first["numbers"])), style=style))
    labels = [axis_label(axis, case, study.settings).removesuffix(" [-]") for axis in (second, first)]
    panel = curves.Panel("", labels[0], f"stable up to: {labels[1]}", lines, from_zero=True)
    caption = (
        f"{conditions(one, case)} The curves are the {first['key']} up to which a method is stable and nothing else "
        "fails; on the dotted line nothing did. Where a method does not cover the setting it has no mark."
    )
    unit = _unit(labels[1])
    parts = [_least(method, limits, unit) for method, limits in by_method.items()]
    covered = "" if all(len(own) == len(numbers) for own in by_method.values()) else " that it covers"
    sentence = Markup("{} further and further ({}), at every {}{} from {} to {} these stay stable: {}.").format(
        (measures.passive(case.test) or one["scene"]).removesuffix(" by").capitalize(),
        mesh_text(case),
        labels[0],
        covered,
        second["values"][0],
        second["values"][-1],
        Markup(", ").join(parts),
    )
    figure = Figure("answer_limits", caption, curves.draw, ([panel], SIZE, 3))
    return Answer("Where do they fail?", figure, sentence, "atlas")


def _curve(method, limits, numbers):
    limits = sorted(limits, key=lambda limit: numbers[limit["other"]])
    x = np.array([numbers[limit["other"]] for limit in limits], dtype=float)
    return curves.Curve(method, x, np.array([limit["low"] or 0 for limit in limits], dtype=float))


def _unit(label):
    """Of "deformation [%]", with the space before it."""
    return f" {label.rpartition('[')[2].removesuffix(']')}" if label.endswith("]") else ""


def _least(method, limits, unit):
    """Where a method's lowest limit is: "mss-cf to 36 % (then wrinkling)"; "at least to 60 %" where nothing failed."""
    weakest = min(limits, key=lambda limit: limit["low"] or 0)
    if weakest["low"] is None:
        return Markup("{} nowhere ({})").format(bold(method), weakest["failure"])
    value = case_number(weakest["low"], weakest["case"])
    if weakest["high"] is None:
        return Markup("{} at least to {}{}").format(bold(method), value, unit)
    return Markup("{} to {}{} (then {})").format(bold(method), value, unit, weakest["failure"])
