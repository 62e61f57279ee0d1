"""Cases along one setting, all others the same, and the explorer's view of them."""

from content import bullets
from markupsafe import Markup
from study import is_variant, problem_columns

_MOST = 2  # the rest is in the explorer


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
    return [group for _, _, group in found[:_MOST]]


_ALONG = {"nu": 3, "deformation": 3, "cells.x": 3, "diagonal-ratio": 3, "dt-ratio": 3}  # values that it takes


def explorer_links(study, test):
    """To the explorer, for what the cases of a test run along; no block where they do not."""
    cases = study.cases[study.cases.test == test]
    items = []
    for along, least in _ALONG.items():
        if cases[along].nunique() >= least:
            label = study.settings[along.partition(".")[0]]["label"]
            address = f"#explore?test={test}&x={along}"
            items.append(Markup('<a href="{}">{}</a> over {}').format(address, test.capitalize(), label))
    return [bullets(items)] if items else []
