"""What the program tells of its measures and tests (data/vocabulary.json, as `springcheck list
measures` and `tests` print it)."""

from typing import NamedTuple

import numpy as np
from springcheck_results import COMPONENTS

_measures, _tests = {}, {}


class Answer(NamedTuple):
    """What a body answers to a test's load with, where that is one number."""

    column: str
    label: str
    unit: str


def learn(vocabulary):
    """Before anything is asked."""
    _measures.update(vocabulary["measures"])
    _tests.update(vocabulary["tests"])


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


def columns():
    """(column, label, unit) of every number, of vectors and matrices by component."""
    found = []
    for name, entry in _measures.items():
        found += [
            (f"{name}.{component}", f"{entry['label']}, {component}", entry["unit"])
            for component in COMPONENTS.get(entry["components"], [])
        ] or [(name, entry["label"], entry["unit"])]
    return found


def answer_name(test):
    """The measure that a test's load is answered with; "" of a test without one."""
    return _tests.get(test, {}).get("answer", "")


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


def off(name, values, others):
    """How far a measure is from others', as the program compares it: the difference, or
    that over the others' own."""
    difference = values - others
    if _measures[name]["compared"] != "ratio":
        return difference
    with np.errstate(divide="ignore", invalid="ignore"):
        return difference / np.abs(others)
