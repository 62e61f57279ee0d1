"""Cases along one setting, all others the same, and the explorer's view of them."""

from case_words import is_variant
from content import paragraph
from markupsafe import Markup
from study import problem_columns

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


_ALONG = {
    "nu": "Poisson's ratio",
    "deformation": "the deformation",
    "cells.x": "the cells across",
    "diagonal-ratio": "A = k_f/k_c",
    "dt-ratio": "the time step over its limit",
}
_LEAST_VALUES = 3


def explorer_links(study, test):
    """To the explorer, for what the cases of a test run along; no block where they do not."""
    cases = study.cases[study.cases.test == test]
    links = []
    for along, words in _ALONG.items():
        if cases[along].nunique() >= _LEAST_VALUES:
            address = f"#explore?test={test}&x={along}"
            links.append(Markup('<a href="{}">{}</a>').format(address, words))
    return [paragraph("In the explorer: over {}.", Markup(", over ").join(links))] if links else []
