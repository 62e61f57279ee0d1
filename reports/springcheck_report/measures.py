"""What the program tells of its measures, tests and statuses (data/vocabulary.json, as `springcheck
list measures`, `tests` and `statuses` print it)."""

from typing import NamedTuple

import numpy as np
from springcheck_results import COMPONENTS

_measures, _tests, _statuses = {}, {}, {}


class Answer(NamedTuple):
    """What a body answers to a test's load with, where that is one number."""

    column: str
    label: str
    unit: str


def learn(vocabulary):
    """Before anything is asked."""
    _measures.update(vocabulary["measures"])
    _tests.update(vocabulary["tests"])
    _statuses.update(vocabulary["statuses"])


def label(name):
    """ "plate force", in words for people."""
    return _measures[name]["label"]


def unit(name):
    """SI, "" of fractions."""
    return _measures[name]["unit"]


def heading(name):
    """ "deviation L2 [%]", with the unit that people read it in."""
    shown = _measures[name]["shown_unit"]
    return f"{label(name)} [{shown}]" if shown else label(name)


def numbers():
    """Names of those that are one number."""
    return [name for name, entry in _measures.items() if entry["components"] == 1]


class Column(NamedTuple):
    """A number of a result file, and what it is multiplied by to have the unit that people read it in."""

    name: str
    label: str
    unit: str
    factor: float


def columns():
    """Of every measure, of vectors and matrices by component."""
    found = []
    for name, entry in _measures.items():
        shown = entry["shown_unit"], entry["shown_factor"]
        found += [
            Column(f"{name}.{component}", f"{entry['label']}, {component}", *shown)
            for component in COMPONENTS.get(entry["components"], [])
        ] or [Column(name, entry["label"], *shown)]
    return found


def answer_name(test):
    """The measure that a test's load is answered with; "" of a test without one."""
    return _tests.get(test, {}).get("answer", "")


def answer_in(case):
    """The case's number of the measure that its test's load is answered with, of a vector its
    length, in SI; NaN where there is none."""
    name = answer_name(case.test)
    if not name:
        return np.nan
    components = COMPONENTS.get(_measures[name]["components"], [])
    if components:
        return np.linalg.norm([case.get(f"{name}.{component}", np.nan) for component in components])
    return case[name]


def answer(test):
    """That as an Answer; None where there is none, or it is no single number."""
    return answers().get(test)


def answers():
    """Every test's, in the order in which the program lists them."""
    names = {test: entry["answer"] for test, entry in _tests.items()}
    return {
        test: Answer(name, label(name), unit(name))
        for test, name in names.items()
        if name and _measures[name]["components"] == 1
    }


def answer_names():
    """Measures that answer a test's load."""
    return {entry["answer"] for entry in _tests.values() if entry["answer"]}


def turns(test):
    """Whether the test's deformation is an angle."""
    return _tests.get(test, {}).get("turns", False)


def passive(test):
    """What a body went through in a test, before its load: "pressed by"; None of tests that have no such words."""
    return _tests[test]["passive"] or None


def told_tests():
    """Tests that have such words, in the program's order."""
    return [test for test in _tests if passive(test)]


def description(test):
    """What happens in a test, a sentence."""
    text = _tests[test]["description"]
    return text[0].upper() + text[1:] + "."


def said(status):
    """What is said of a method whose case ended so, behind its name."""
    return _statuses.get(status, {}).get("said") or f"ended {status}"


def equilibria():
    """Statuses of cases that ended in an equilibrium, stable or not."""
    return [name for name, entry in _statuses.items() if entry["equilibrium"]]


def off(name, values, others):
    """How far a measure is from others', as the program compares it: the difference, or
    that over the others' own."""
    difference = values - others
    if _measures[name]["compared"] != "ratio":
        return difference
    with np.errstate(divide="ignore", invalid="ignore"):
        return difference / np.abs(others)
