"""Reads springcheck's result files.

    import springcheck_results as results
    file = results.read("sweep.h5")
    file.cases.query("method == 'mss-cf'").plot("nu", "volume_error")

Nothing is written; a file that a sweep is writing may be read at any time.
"""

import hashlib
import io
import os
import struct
import time
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import unquote

import h5py
import numpy as np
import pandas as pd

LAYOUT = 2
_PAGE = 4096
_MAGIC = b"springcheck journal 1\n".ljust(32, b"\0")
CELLS = ["tetrahedra", "pyramids", "prisms", "hexahedra"]
COMPONENTS = {3: ["x", "y", "z"], 9: ["xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"]}
# Columns of a history in files of before 0.3.0, which do not name them.
_UNNAMED = ["time", "load_fraction", "deformation", "volume_change"]
_UNNAMED += [f"{name}_{axis}" for name in ("force", "torque") for axis in COMPONENTS[3]]
_UNNAMED += ["kinetic_energy", "strain_energy"]
_UNNAMED += [f"stress_{component}" for component in COMPONENTS[9]]


@dataclass
class Frame:
    """The body on the way of a case in dynamics. sample: its row of the history."""

    sample: int
    displacement: np.ndarray  # nodes x 3 [m]
    cell_volume_ratio: np.ndarray  # of each cell


@dataclass
class Results:
    """A result file as it was when it was read.

    cases: one row per case, indexed by its key; columns are settings and measures under
        the names they have in JSON and scene files, in SI units. Vectors are one column
        per component ("force.z"). What was not computed is NaN, or None for texts.
        `revision` is that of the numerics behind the row, None in files from before there
        were any: rows of different revisions are answers of different programs, and one
        file may hold the same case several times.
    provenance: one row for each time the file was written; `cases.provenance` refers to it.
    """

    path: Path
    cases: pd.DataFrame
    provenance: pd.DataFrame

    def fields(self, key):
        """Arrays of a case by name: displacement, deviation (from the reference) and
        reaction (nodes x 3) [m, m, N], cell_volume_ratio, spring_strain (one per cell);
        "partial_" before each when the case ended without an equilibrium; history (see
        there). Empty where the file holds none. KeyError for an unknown case."""
        return self._arrays(key, lambda name: not name.startswith("frame_"))

    def _arrays(self, key, is_wanted):
        if key not in self.cases.index:
            raise KeyError(f"no case {key!r}")

        def arrays(file):
            group = file["fields"].get(key, {})
            return {name: group[name][()] for name in group if is_wanted(name)}

        return _at_rest(self.path, arrays)

    def history(self, key):
        """What a case in dynamics sampled on its way, a row per moment: time [s],
        load_fraction, deformation, volume_change, force and torque on the moved plate by
        axis ("force_x") [N, N m], kinetic_energy and strain_energy [J], mean_stress by
        component ("stress_xx", in affine) [Pa] and answer, the measure that answers the
        test's load. Older files lack the last ones. None where the file holds none.
        KeyError for an unknown case."""
        samples = self.fields(key).get("history")
        if samples is None:
            return None

        def names(file):
            return file["fields"][key].attrs.get("history_columns")

        told = _at_rest(self.path, names)
        return pd.DataFrame(samples, columns=told.split() if told else _UNNAMED[: samples.shape[1]])

    def frames(self, key):
        """The body of a case in dynamics at some samples of its history, in their order: a
        list of Frame, empty where the file holds none. KeyError for an unknown case."""
        fields = self._arrays(key, lambda name: name.startswith("frame_"))
        if not fields:
            return []
        samples = fields["frame_sample"].ravel().astype(int)
        parts = [
            np.split(fields[f"frame_{name}"], len(samples))
            for name in ("displacement", "cell_volume_ratio")
        ]
        return [Frame(int(sample), *own) for sample, *own in zip(samples, *parts)]

    def field_names(self):
        """Names of the arrays that each case has, by key; without those that have none."""
        return _at_rest(
            self.path,
            lambda file: {key: set(group) for key, group in file["fields"].items() if len(group)},
        )

    def mesh(self, key):
        """Of a case's mesh: nodes (n x 3) [m]; tetrahedra (cells x 4), pyramids (5), prisms
        (6) and hexahedra (8), those there are; regions, name to faces (n x 4), of
        triangles the last node twice. Fields of cells follow the types in this order."""
        name = self.cases.loc[key, "mesh"]

        def arrays(file):
            group = file["meshes"][name]
            cells = {name: group[name][()] for name in CELLS if name in group}
            regions = {unquote(name): faces[()] for name, faces in group["regions"].items()}
            return {"nodes": group["nodes"][()], **cells, "regions": regions}

        return _at_rest(self.path, arrays)


def read(path):
    """Reads a result file. ValueError, naming the file, where it is none of layout 2;
    FileNotFoundError where there is none."""
    path = Path(os.path.realpath(path))

    def tables(file):
        layout = file.attrs.get("layout")
        if layout is None:
            raise ValueError("HDF5 of others")
        if layout != LAYOUT:
            raise ValueError(f"layout {layout} instead of {LAYOUT}")
        cases, provenance = _table(file["cases"]), _table(file["provenance"])
        if cases.empty:
            cases = pd.DataFrame({"key": []})
        elif "revision" in provenance:
            cases["revision"] = provenance.revision.loc[cases.provenance].to_numpy()
        else:
            cases["revision"] = None
        return cases.set_index("key"), provenance

    cases, provenance = _at_rest(path, tables)
    return Results(path, cases, provenance)


def _table(group):
    columns = {}
    for name, column in group.items():
        values = column[()]
        if values.dtype.kind == "S":
            texts = np.char.decode(values, "utf-8").astype(object)
            columns[name] = np.where(texts == "", None, texts)
        elif values.ndim == 1:
            columns[name] = values
        else:
            for i, component in enumerate(COMPONENTS[values.shape[1]]):
                columns[f"{name}.{component}"] = values[:, i]
    return pd.DataFrame(columns)


def _at_rest(path, look):
    """look(file) of the file as it is between two changes. A writer changes it within
    milliseconds, between the making of a whole journal and its removal; a journal that
    stays is of a writer that was killed, and is applied to a copy in memory. Whatever is
    wrong with the content is a ValueError that names the file."""
    journal = Path(f"{path}-journal")
    for _ in range(100):
        before, pages = _state(path), _read_journal(journal)
        if pages is None:
            failure = found = None
            try:
                with h5py.File(path, "r") as file:
                    found = look(file)
            except Exception as error:  # pylint: disable=broad-except
                failure = error
            if _state(path) == before and _read_journal(journal) is None:
                if failure is None:
                    return found
                raise _unreadable(path, failure) from failure
        time.sleep(0.02)
    if pages is None:
        raise _unreadable(path, "one that changes faster than it can be read")
    try:
        content = _applied(path.read_bytes(), *pages)
        with h5py.File(io.BytesIO(content), "r") as file:
            return look(file)
    except Exception as error:
        raise _unreadable(path, error) from error


def _unreadable(path, got):
    return ValueError(f"{path}: expected a readable springcheck result file, got {got}")


def _state(path):
    status = os.stat(path)
    return status.st_mtime_ns, status.st_size


def _read_journal(path):
    """(new size of the file, {page number: bytes}), None unless the journal is whole;
    comparisons/store/journal.hpp describes it."""
    try:
        content = path.read_bytes()
    except FileNotFoundError:
        return None
    body, digest = content[:-64], content[-64:]
    if not body.startswith(_MAGIC) or hashlib.sha256(body).hexdigest().encode() != digest:
        return None
    size, count = struct.unpack_from("<QQ", body, len(_MAGIC))
    pages = {}
    at = len(_MAGIC) + 16
    for _ in range(count):
        (number,) = struct.unpack_from("<Q", body, at)
        old_hash = body[at + 8 : at + 72]
        pages[number] = old_hash, body[at + 72 : at + 72 + _PAGE]
        at += 72 + _PAGE
    return size, pages


def _applied(content, size, pages):
    """The bytes that the journal leads to. ValueError where it is of other content."""
    changed = bytearray(content)
    for number, (old_hash, page) in pages.items():
        start, end = number * _PAGE, (number + 1) * _PAGE
        present = bytes(changed[start:end]).ljust(_PAGE, b"\0")
        if present != page and hashlib.sha256(present).hexdigest().encode() != old_hash:
            raise ValueError("the journal beside it is of other content")
        changed.extend(b"\0" * (end - len(changed)))
        changed[start:end] = page
    return bytes(changed[:size])
