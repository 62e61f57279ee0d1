"""What a report is about: the cases of a result file with what belongs to them."""

import json
from dataclasses import dataclass
from functools import lru_cache

import measures
import methods
import numpy as np
import pandas as pd
import springcheck_results
from case_words import case_text, load_text, load_words, method_name, setting_text

# Columns other than settings and measures that a report reads; a file lacks those that none of its cases
# has.
_TEXTS = ["scene", "mesh", "status", "flags", "reason", "source", "reference"]
_NUMBERS = ["load_fraction", "steps", "provenance"]

# Statuses whose measures are those of an equilibrium worth comparing.
USABLE = "ok"


@dataclass
class Study:
    """A result file, with the tables and theory that were made from it.

    cases: those of the file, and further columns: `name` (method, element and what else
        tells methods apart), `kind` ("springs", "finite elements" or "measured"),
        `problem` (the same for all methods on the same mesh, material and load), `load`
        in words: both at the load that was reached, which the columns of a load hold, too;
        `whole_problem`, `whole_deformation` and `whole_load` by all of a path's; `answer`
        (of its test, SI), `counterpart` (key of the finite elements that solve the same
        problem, or None), `volume_difference` and `answer_difference` from them (volume
        as a fraction of V0, answer relative), `strain`: the size of the deformation (of a
        beam its tip's drop over its length).
        `is_judged`: whether that counterpart is good enough to judge by. `is_repeated`: the
        same simulation is there already, with another reference. `further`: the settings that
        tell a case from others of the same name and text, in words, or "".
    limits: cases of solver limit, which end where a path does and not at their load, apart
        from all others.
    tables: JSON documents of tables/ by name. theory: data/theory.json. atlas:
        data/atlas.json, the maps of `springcheck stability`, with how their cases fail.
    charts: data/charts.json, see comparisons/chart/chart_json.hpp.
    vocabulary: data/vocabulary.json, what `springcheck list` tells.
    note: what there is of other revisions of the numerics and what becomes of it; or "".
    """

    results: springcheck_results.Results
    cases: pd.DataFrame
    limits: pd.DataFrame
    tables: dict
    theory: dict
    atlas: dict
    charts: list
    vocabulary: dict
    note: str

    def __post_init__(self):
        self.field_names = self.results.field_names()
        self._fields = lru_cache(maxsize=64)(self.results.fields)
        self._is_whole = lru_cache(maxsize=None)(self._find_out_if_whole)
        self._meshes = lru_cache(maxsize=64)(
            lambda name: self.results.mesh((self.cases["mesh"] == name).idxmax())
        )

    @property
    def settings(self):
        return self.vocabulary["settings"]

    @property
    def distinct(self):
        """Cases without those that are there already, with another reference."""
        return self.cases[~self.cases.is_repeated]

    def _find_out_if_whole(self, key):
        if not (self.has(key, "displacement") and self.has(key, "cell_volume_ratio")):
            return False
        mesh, fields = self.mesh(key), self._fields(key)
        cells = sum(len(mesh[name]) for name in springcheck_results.CELLS if name in mesh)
        return (
            fields["displacement"].shape == mesh["nodes"].shape
            and fields["cell_volume_ratio"].shape == (cells,)
            and bool(np.isfinite(fields["displacement"]).all())
            and bool(np.isfinite(fields["cell_volume_ratio"]).all())
        )

    def has(self, key, name):
        """Whether the file holds this field of the case."""
        return name in self.field_names.get(key, ())

    def keys_with_fields(self):
        """Of cases with fields, whole or partial, in the order of the file's groups."""
        return [key for key in self.field_names if key in self.cases.index]

    def field(self, key, name):
        """A stored field of a case, None where the file holds none."""
        return self._fields(key)[name] if self.has(key, name) else None

    def history(self, key):
        """What a case sampled on its way through time, as springcheck_results gives it."""
        return self.results.history(key) if self.has(key, "history") else None

    def frames(self, key):
        """The body on the way, as springcheck_results gives it."""
        return self.results.frames(key) if self.has(key, "frame_sample") else []

    def mesh(self, key):
        """The mesh of a case, as springcheck_results gives it."""
        return self._meshes(self.cases.loc[key, "mesh"])

    def case(self, key):
        """A case, wherever its path ends; None where the file lacks it."""
        for table in (self.cases, self.limits):
            if key in table.index:
                return table.loc[key]
        return None

    def with_fields(self, cases):
        """Those cases of a table that have an equilibrium's whole fields."""
        return cases[_mask(self._is_whole(key) for key in cases.index)]


def read(file, folder):
    """The study of a result file and the folder of its report."""
    results = springcheck_results.read(file)
    tables = {}
    for path in sorted((folder / "tables").glob("*.json")):
        document = json.loads(path.read_text(encoding="utf-8"))
        if document.get("table") == path.stem:  # others' files may lie there
            tables[path.stem] = document
    if "cases" in tables:  # the file may have grown since the tables were made
        known = {row["case"] for row in tables["cases"]["rows"]}
        results.cases = results.cases[results.cases.index.isin(known)]
    names = ("theory.json", "atlas.json", "vocabulary.json")
    theory, atlas, vocabulary = (_document(folder / "data" / name) for name in names)
    charts = _document(folder / "data" / "charts.json") or []
    note = (_document(folder / "data" / "revisions.json") or {}).get("note", "")
    settings = vocabulary["settings"]
    methods.learn(vocabulary)
    measures.learn(vocabulary)
    cases = results.cases
    is_limit = _mask(cases["solver"] == "limit") if "solver" in cases else np.zeros(len(cases), bool)
    limits = prepared(cases[is_limit], settings) if is_limit.any() else pd.DataFrame()
    judged = prepared(cases[~is_limit], settings)
    return Study(results, judged, limits, tables, theory, atlas, charts, vocabulary, note)


def _document(path):
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}


def _mask(truths):
    """Of rows; an empty list would choose columns."""
    return np.fromiter(truths, dtype=bool)


def setting_columns(key, setting):
    """Names of a setting's columns in a result file, and what they hold in cases without it:
    numbers of a list that is no vector or matrix are a text there."""
    components = springcheck_results.COMPONENTS.get(setting["most"], [])
    if setting["kind"] in ("number", "integer") and (components or setting["most"] == 1):
        return [f"{key}.{component}" for component in components] or [key], np.nan
    return [key], None


def problem_columns(settings):
    """Columns of what makes the mechanical problem, whatever method solves it. `mesh` is the
    mesh's SHA-256, which stands for the body's own settings."""
    columns = ["test", "mesh"]
    for key, setting in settings.items():
        if setting["group"] in ("material", "load") or (setting["beside"] == "mesh" and setting["column"]):
            columns += setting_columns(key, setting)[0]
    return columns


def load_columns(settings):
    """Columns of what grows with the load."""
    loads = {key: setting for key, setting in settings.items() if setting["group"] == "load"}
    numbers = [setting_columns(key, setting) for key, setting in loads.items() if setting["kind"] == "number"]
    return [column for columns, _ in numbers for column in columns]


def _problems(cases, settings):
    """The mechanical problem of each case. Loads to 12 digits: a part of one is computed."""
    columns = problem_columns(settings)
    shown = cases[columns].astype(object).where(cases[columns].notna(), None)
    for column in load_columns(settings):
        shown[column] = [None if load is None else float(f"{load:.12g}") for load in shown[column]]
    return [json.dumps(list(record)) for record in shown.itertuples(index=False)]


def prepared(cases, settings):
    """Cases with all columns that a report reads and those that it adds, see Study."""
    lacking = dict.fromkeys(_TEXTS) | dict.fromkeys([*_NUMBERS, *measures.numbers()], np.nan)
    for key, setting in settings.items():
        names, nothing = setting_columns(key, setting)
        lacking |= dict.fromkeys(names, nothing)
    further = {name: nothing for name, nothing in lacking.items() if name not in cases}
    cases = pd.concat([cases, pd.DataFrame(further, index=cases.index)], axis=1)
    cases["whole_problem"], cases["whole_deformation"] = _problems(cases, settings), cases.deformation
    loads = load_columns(settings)
    has_end = cases.status.isin(measures.equilibria()) & (cases.solver != "limit") & cases.load_fraction.notna()
    cases["ends_early"] = has_end & (cases.load_fraction != 1)
    reached = cases.load_fraction.where(cases.ends_early, 1)
    whole = {key: load_words(case) for key, case in cases[cases.ends_early].iterrows()}
    cases[loads] = cases[loads].astype(float).mul(reached, axis=0)
    cases["problem"] = _problems(cases, settings)
    added = {"kind": _kind, "name": method_name, "load": load_text, "answer": measures.answer_in}
    values = [[of(row) for of in added.values()] for _, row in cases.iterrows()]
    for place, name in enumerate(added):
        cases[name] = [value[place] for value in values]
    cases["whole_load"] = [whole.get(key, load) for key, load in cases.load.items()]
    cases["strain"] = cases.deformation.astype(float).abs()
    beams = (cases.test == "bending") & (cases.body == "block")
    cases.loc[beams, "strain"] = cases.tip_deflection / cases["size.z"]
    cases["counterpart"], cases["is_judged"] = _counterparts(cases)
    cases["further"] = _further(cases, settings)
    cases["is_repeated"] = cases.duplicated(["problem", "name", "load", "further"])
    other = cases.reindex(cases["counterpart"].tolist())
    theirs = {name: other[name].to_numpy(dtype=float) for name in ("volume_change", "answer")}
    cases["volume_difference"] = measures.off("volume_change", cases.volume_change, theirs["volume_change"])
    cases["answer_difference"] = np.nan
    for test in set(cases.test):
        if name := measures.answer_name(test):
            own = (cases.test == test).to_numpy()
            cases.loc[own, "answer_difference"] = measures.off(name, cases.answer[own], theirs["answer"][own])
    return cases


def _further(cases, settings):
    """The settings that differ between cases of one name and text, in words: "density 1060"."""
    further = pd.Series("", index=cases.index)
    texts = [case_text(case) for _, case in cases.iterrows()]
    labels = cases.assign(text=texts)[["name", "text"]].agg("\n".join, axis=1)
    alike = cases[labels.duplicated(keep=False).to_numpy()]
    if alike.empty:
        return further
    for key, setting in settings.items():
        columns, _ = setting_columns(key, setting)
        if not setting["column"] or (alike[columns].nunique(dropna=False) == 1).all():
            continue
        values = alike[columns].agg(lambda row: "/".join(filter(None, map(setting_text, row))), axis=1)
        differs = values.groupby(labels[alike.index]).transform("nunique") > 1
        told = values[differs & (values != "")]
        further[told.index] += f", {key} " + told
    return further.str.removeprefix(", ")


def _kind(case):
    """As the file says; files of before 0.3.0 do not."""
    own = case.get("family")
    if not own:
        own = "measured" if case.get("source") == "measured" else methods.family(case.method)
    return own or "springs"


def is_through_time(case):
    """Whether a case ends a motion instead of being an equilibrium."""
    return case.kind != "measured" and case.solver not in (None, "static")


def _counterparts(cases):
    """(keys of the finite elements on the same problem, for each case that is none itself, those of
    its own law before others; whether they are good enough to judge by)."""
    reference = cases[(cases.kind == "finite elements") & (cases.status == USABLE)]
    laws = methods.foremost("finite elements")
    others = {}
    for key, case in reference.iterrows():
        if not methods.law(case.method) or case.method not in laws:
            continue
        rank = laws.index(case.method), methods.locks(case.method, case.element), case.element
        others.setdefault(case.problem, []).append((rank, key, methods.law(case.method)))
    keys = []
    for _, case in cases.iterrows():
        known = others.get(case.problem, []) if case.kind != "finite elements" else []
        own = [one for one in known if one[2] == methods.law(case.method)]
        keys.append(min(own or known)[1] if known else None)
    judges = {key for key in keys if key is not None and _is_judge(cases.loc[key])}
    return keys, [key in judges for key in keys]


def _is_judge(case):
    """Whether finite elements are right enough to judge springs by: not where they lock, and on
    hexahedra only, since linear ones on other cells are further from the converged value than springs may
    be."""
    is_grid = case.body == "block" and case["cell-type"] == "hexahedron"
    return is_grid and not methods.locks(case.method, case.element)
