"""What the page's explorer and its view of a case read: every case with its settings and measures."""

import math

import measures
import method_style
import methods
import numpy as np
import pandas as pd
from case_command import case_command
from case_words import is_variant, mesh_text
from measures import Column
from study import load_columns, setting_columns

# Plotly's names of matplotlib's markers.
_MARKS = {"o": "circle", "s": "square", "D": "diamond", "d": "diamond-tall", "P": "cross", "X": "x", "*": "star"}
_MARKS |= {"^": "triangle-up", "v": "triangle-down", "<": "triangle-left", ">": "triangle-right", "p": "pentagon"}
_MARKS |= {"h": "hexagon", "H": "hexagon2", "8": "octagon", "1": "y-down-open", "2": "y-up-open", "3": "y-left-open"}
_DASHES = {"-": "solid", "--": "dash", ":": "dot", "-.": "dashdot"}

# Measures that no column of the file is: differences from finite elements on the same problem.
_COMPARED = [
    Column("answer_difference", "force, torque or tip off elements", "%", 100),
    Column("volume_difference", "volume off elements", "% of V0", 100),
]


def explorer_data(study):
    """{file, columns: {key: {label, unit, factor, role, kind, values, codes}}, looks: of methods, answers: the
    measure that each test answers with, usual: methods that are shown at first, statuses: their colours}. values:
    of every case; where they repeat each once, and codes: the place of each case's own, -1 for none. factor: of
    measures, what turns the value into the unit. role: "name" of what tells cases apart in words, "setting",
    "measure"; kind: "number" or "text"."""
    tables = [table for table in (study.cases, study.limits) if not table.empty]
    cases = pd.concat(tables) if len(tables) > 1 else tables[0]
    parts = [_names(study, cases), _settings(study, cases), _measures(cases)]
    columns = {key: column for part in parts for key, column in part.items()}
    assert len(columns) == sum(map(len, parts)), "two columns of one name"
    return {
        "file": study.results.path.name,
        "columns": columns,
        "looks": {name: _look(name) for name in dict.fromkeys(cases["name"])},
        "usual": [name for name in dict.fromkeys(cases["name"]) if _is_usual(name)],
        "answers": {test: own.column for test, own in measures.answers().items() if (cases.test == test).any()},
        "statuses": method_style.STATUS_COLOURS,
    }


def _names(study, cases):
    scenes = study.vocabulary["scenes"]
    wholes = cases.copy()  # paths that end early were asked for more
    loads = [column for column in load_columns(study.settings) if column in study.results.cases]
    wholes[loads] = study.results.cases.loc[cases.index, loads]
    texts = {
        "key": (cases.index, "key"),
        "name": (cases["name"], "method with its variants"),
        "model": ([f"{m}:{e}" if e else m for m, e in zip(cases.method, cases.element)], "method"),
        "kind": (cases["kind"], "family"),
        "status": (cases["status"], "status"),
        "reason": (cases["reason"], "why"),
        "test": (cases["test"], "test"),
        "scene": (cases["scene"], "scene"),
        "load": (cases["load"], "load"),
        "material": ([methods.law(method) or None for method in cases.method], "law of the material"),
        "cells": (_meshes(cases), "mesh"),
        "reference": (cases["reference"], "reference of the deviations"),
        "judge": (cases["name"].reindex(cases["counterpart"]), "finite elements on the same problem"),
        "command": ([case_command(case, study.settings, scenes) for _, case in wholes.iterrows()], "command"),
    }
    return {key: {"label": label, "role": "name", **_column(values)} for key, (values, label) in texts.items()}


def _meshes(cases):
    """In words, with the size of the body where that alone tells two apart."""
    texts = pd.Series([mesh_text(case) for _, case in cases.iterrows()], index=cases.index)
    lengths = cases[[f"size.{axis}" for axis in "xyz"]].to_numpy(dtype=float)
    sizes = pd.Series([" × ".join(f"{length:.3g}" for length in row) for row in lengths], index=cases.index)
    differs = sizes.groupby(texts).transform("nunique") > 1
    return texts.where(~differs, texts + ", " + sizes + " m")


def _settings(study, cases):
    found = {}
    for key, setting in study.settings.items():
        if key in ("method", "element", "test", "reference", "expect"):
            continue
        names, _ = setting_columns(key, setting)
        for name in names:
            if name not in cases or cases[name].isna().all():
                continue
            label = setting["label"] if name == key else f"{setting['label']}, {name.rpartition('.')[2]}"
            unit = setting["si_unit"] if setting["si_unit"] != "-" else ""
            column = {"label": label, "unit": unit, "role": "setting", "group": setting["group"]}
            column["variant"] = bool(setting["variant"])
            found[name] = column | _column(cases[name])
    return found


def _measures(cases):
    there = [column for column in measures.columns() if column.name in cases and _is_number(cases[column.name])]
    # Even where every case failed:
    answers = {answer.column for test, answer in measures.answers().items() if (cases.test == test).any()}
    return {
        name: {"label": label, "unit": unit, "factor": factor, "role": "measure", **_column(cases[name])}
        for name, label, unit, factor in [*_COMPARED, *there]
        if cases[name].notna().any() or name in answers
    }


def _is_number(values):
    return pd.api.types.is_numeric_dtype(values)


def _column(values):
    """kind and values, with codes where that is shorter."""
    if _is_number(values):
        kind, values = "number", [float(v) if math.isfinite(v) else None for v in np.asarray(values, dtype=float)]
    else:
        kind, values = "text", [value if isinstance(value, str) and value else None for value in values]
    distinct = list(dict.fromkeys(value for value in values if value is not None))
    if 2 * len(distinct) > len(values):
        return {"kind": kind, "values": values}
    places = {value: place for place, value in enumerate(distinct)}
    return {"kind": kind, "values": distinct, "codes": [places.get(value, -1) for value in values]}


def _is_usual(name):
    """At rest, by its usual settings and element, of the methods that people want to see first; or others'."""
    method, _, element = name.partition(":")
    family = methods.family(method)
    known = family is None or method in methods.foremost(family) and methods.own_solver(method) == "static"
    return known and not is_variant(name) and element in ("", methods.default("element"))


def _look(name):
    """As plotly has it."""
    style = method_style.line(name)
    mark = _MARKS.get(style["marker"], "circle")
    is_hollow = style["markerfacecolor"] == "white"
    dash = _DASHES.get(style["linestyle"], "longdashdot") if isinstance(style["linestyle"], str) else "longdashdot"
    return {"colour": style["color"], "mark": f"{mark}-open" if is_hollow else mark, "dash": dash}
