"""Lines through the cases along one setting, all others the same."""

import methods
import numpy as np
from content import Figure
from figures import curves
from study import ANSWERS, is_variant, problem_columns

_MOST_FIGURES = 2  # of one kind in a test; the rest is in the table of all cases


def longest_slices(study, test, along, least):
    """Groups of cases that differ in method and `along` alone, of at least so many values,
    longest first: [(number of values, cases), ...]."""
    cases = study.cases[(study.cases.test == test) & ~study.cases["name"].map(is_variant)]
    fixed = [column for column in problem_columns(study.settings) if column != along]
    found = []
    for _, group in cases.groupby(fixed, dropna=False, sort=False):
        count = group[along].nunique()
        if count >= least:
            found.append((count, len(group), group))
    found.sort(key=lambda entry: (-entry[0], -entry[1]))
    return [group for _, _, group in found[:_MOST_FIGURES]]


def _curves(cases, along, scale, measure, factor):
    found = []
    for name, of_method in cases.groupby("name"):
        of_method = of_method.drop_duplicates(along).sort_values(along)
        if len(of_method) < 2:
            continue
        y = factor * of_method[measure].to_numpy(dtype=float)
        found.append(
            curves.Curve(name, scale * of_method[along].to_numpy(dtype=float), y, list(of_method.status))
        )
    return found


def nu_panels(study, test):
    """Volume error and answer against Poisson's ratio, springs with finite elements but
    those that lock."""
    figures = []
    for i, group in enumerate(longest_slices(study, test, "nu", 5)):
        caption = (
            f"{test.capitalize()}, {group.iloc[0].load}, against Poisson's ratio. Rings and crosses "
            "mark cases that are not ok; a cross at the floor has no equilibrium at all."
        )
        locks = [methods.locks(case.method, case.element) for _, case in group.iterrows()]
        group = group[~np.array(locks, dtype=bool)]
        panels = _two_panels(group, test, "nu", 1, "Poisson's ratio")
        figures.append(Figure(f"nu_{test}_{i + 1}", caption, curves.draw, (panels,)))
    return figures


def deformation_panels(study, test):
    """Volume error and answer against the deformation."""
    figures = []
    angle = test == "torsion"
    scale = np.degrees(1) if angle else 100
    for i, group in enumerate(longest_slices(study, test, "deformation", 4)):
        caption = f"{test.capitalize()} from small to large deformation at nu = {group.iloc[0].nu:g}."
        springs, continuum = methods.of_thesis(), methods.continuum_of_lattices()
        if {springs, continuum} <= set(group.method):
            caption += f" Where the laws part, {springs} follows the continuum of its own lattice, {continuum}."
        label = "angle [°]" if angle else "deformation [%]"
        panels = _two_panels(group, test, "deformation", scale, label)
        figures.append(Figure(f"deformation_{test}_{i + 1}", caption, curves.draw, (panels,)))
    return figures


def _two_panels(group, test, along, scale, x_label):
    measure, answer, unit = ANSWERS[test]
    volume = curves.Panel(
        "Volume error", x_label, "|V − V₀|/V₀ [%]", _curves(group, along, scale, "volume_error", 100)
    )
    force = curves.Panel(
        answer.capitalize(), x_label, f"{answer} [{unit}]", _curves(group, along, scale, measure, 1)
    )
    return [volume, force]
