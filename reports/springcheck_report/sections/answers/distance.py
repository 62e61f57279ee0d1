"""How far springs are from finite elements, over Poisson's ratio."""

import measures
import numpy as np
import pandas as pd
from case_words import mesh_text
from content import Answer, Figure
from figures import curves
from markupsafe import Markup
from sections.answers.words import SIZE, bold, case_number, first_and_nearest, foremost_springs, gone_through
from sections.slices import longest_slices
from study import USABLE

_LEAST_VALUES = 3  # of Poisson's ratio
_LEAST_SHOWN = 0.001  # percent
_ALIKE = 1e-9  # ranges of V/V0 that rounding alone explains
_FEW = 4  # springs, up to which others than the foremost join


def distance_over_nu(study):
    """Of the plate force, torque or drop, in the first test that has it over Poisson's ratio."""
    for test in measures.told_tests():
        for group in longest_slices(study, test, "nu", _LEAST_VALUES):
            by_name = _comparable(group)
            if by_name:
                return _answer(study, test, by_name)
    return None


def _comparable(group):
    """{springs: their cases, failed ones too}, of those that can be judged at enough of the values: the
    foremost, and others where these are few."""
    group = group[~group.is_repeated].sort_values("nu")
    springs = group[group.kind == "springs"]["name"]
    foremost = foremost_springs(springs)
    by_name = {}
    for name in [*foremost, *sorted(set(springs) - set(foremost))]:
        cases = group[group["name"] == name]
        if _distances(cases).count() >= _LEAST_VALUES and (name in foremost or len(by_name) < _FEW):
            by_name[name] = cases
    return by_name


def _distances(cases):
    """Percent; none where a case failed, or no elements judge it."""
    return 100 * cases.answer_difference.abs().where((cases.status == USABLE) & cases.is_judged)


def _answer(study, test, by_name):
    answer = measures.answer(test).label
    first = next(iter(by_name.values())).iloc[0]
    distances = {name: _distances(cases) for name, cases in by_name.items()}
    known = pd.concat([by_name[name][sizes.notna()] for name, sizes in distances.items()])
    judges = sorted({study.cases.loc[key, "name"] for key in known.counterpart})
    lines = [
        curves.Curve(
            name,
            cases.nu.to_numpy(float),
            np.maximum(distances[name].to_numpy(float), _LEAST_SHOWN),
            list(cases.status),
        )
        for name, cases in by_name.items()
    ]
    panel = curves.Panel("", study.settings["nu"]["label"], f"{answer} off elements [%]", lines, log_y=True)
    caption = (
        f"How far the {answer} of springs is from that of finite elements of their own law, or of Hencky's where "
        f"they follow none ({', '.join(judges)}), {mesh_text(first)}, {first.load}, against Poisson's ratio: the "
        f"size of the difference, whose sign may change. Less than {_LEAST_SHOWN:g} % is drawn there."
    )
    at_zero = study.cases.loc[known.counterpart[known.nu == 0]]
    if len(at_zero) and (at_zero.cell_volume_ratio_max - at_zero.cell_volume_ratio_min).max() < _ALIKE:
        caption += " At nu = 0 all cells of the finite elements are strained alike: no mesh of theirs errs there."
    # Springs that fail are none of the nearest, where others do not.
    ranks = {name: ((by_name[name].status != USABLE).any(), sizes.max()) for name, sizes in distances.items()}
    named = first_and_nearest(ranks)
    sentence = Markup(
        "{} ({}): the {} of {} off finite elements on the same mesh, over Poisson's ratios from {:g} to {:g}."
    ).format(
        gone_through(test, first.load),
        mesh_text(first),
        answer,
        Markup(", of ").join(_range(name, by_name[name], distances[name]) for name in named),
        min(by_name[name].nu.min() for name in named),
        max(by_name[name].nu.max() for name in named),
    )
    figure = Figure("answer_distance", caption, curves.draw, ([panel], SIZE, 3))
    address = f"explore?test={test}&x=nu&y=answer_difference"
    return Answer("How far are springs from finite elements?", figure, sentence, address)


def _range(name, cases, sizes):
    """How far a method's cases are off: "mss-cf is 3.1 to 11 % (2 of its 11 cases failed)"."""
    ends = [case_number(sizes[key], key) for key in (sizes.idxmin(), sizes.idxmax())]
    text = Markup("{} is {} to {} %").format(bold(name), *ends)
    failed = (cases.status != USABLE).sum()
    return text + (f" ({failed} of its {len(cases)} cases failed)" if failed else "")
