"""How far springs are from finite elements, over Poisson's ratio."""

import numpy as np
from content import Answer, Figure
from figures import curves
from markupsafe import Markup
from sections.answers.words import SIZE, TESTS, bold, case_number, first_and_nearest, foremost_springs
from sections.slices import longest_slices
from study import ANSWERS, USABLE, mesh_text

_LEAST_VALUES = 3  # of Poisson's ratio
_LEAST_SHOWN = 0.01  # percent


def distance_over_nu(study):
    """Of the plate force, torque or drop, in the first test that has it over Poisson's ratio."""
    for test in TESTS:
        for group in longest_slices(study, test, "nu", _LEAST_VALUES):
            by_name = _judged(group)
            if by_name:
                return _answer(study, test, by_name)
    return None


def _judged(group):
    """{springs: their usable cases with elements to judge them by}, of those with enough."""
    group = group[~group.is_repeated & group.is_judged & (group.status == USABLE)]
    group = group[group.answer_difference.notna()].sort_values("nu")
    by_name = {name: group[group["name"] == name] for name in foremost_springs(group["name"])}
    return {name: cases for name, cases in by_name.items() if cases.nu.nunique() >= _LEAST_VALUES}


def _answer(study, test, by_name):
    answer = ANSWERS[test][1]
    first = next(iter(by_name.values())).iloc[0]
    judges = sorted({study.cases.loc[key, "name"] for cases in by_name.values() for key in cases.counterpart})
    lines = []
    for name, cases in by_name.items():
        distances = 100 * cases.answer_difference.abs().to_numpy(float)
        lines.append(curves.Curve(name, cases.nu.to_numpy(float), np.maximum(distances, _LEAST_SHOWN)))
    panel = curves.Panel("", "Poisson's ratio", f"{answer} off elements [%]", lines, log_y=True)
    caption = (
        f"Difference of the {answer} of springs from that of finite elements ({', '.join(judges)}), "
        f"{mesh_text(first)}, {first.load}, against Poisson's ratio. Less than {_LEAST_SHOWN:g} % is drawn there."
    )
    furthest = {name: cases.answer_difference.abs().max() for name, cases in by_name.items()}
    parts = [_range(name, by_name[name]) for name in first_and_nearest(furthest)]
    sentence = Markup("{}: the {} of {} off finite elements, over Poisson's ratios from {:g} to {:g}.").format(
        TESTS[test].format(first.load),
        answer,
        Markup(", of ").join(parts),
        min(line.x[0] for line in lines),
        max(line.x[-1] for line in lines),
    )
    figure = Figure("answer_distance", caption, curves.draw, ([panel], SIZE, 3))
    return Answer("How far are springs from finite elements?", figure, sentence, test)


def _range(name, cases):
    sizes = 100 * cases.answer_difference.abs()
    ends = [case_number(sizes[key], key) for key in (sizes.idxmin(), sizes.idxmax())]
    return Markup("{} is {} to {} %").format(bold(name), *ends)
