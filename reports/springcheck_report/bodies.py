"""Bodies for the 3D views: which cases, and their surfaces as the page's script reads them."""

import zlib
from dataclasses import dataclass, field
from itertools import groupby

import methods
import numpy as np
import pandas as pd
from case_words import case_text
from strains import equivalent_strains
from surface import outside

# Bytes of all views together as the page has them, packed but for base64, which makes a third
# more of them: pages stay below 15 MB. What was recorded on the way has a share of its own.
_BUDGET = 3.2e6
_BUDGET_OF_FRAMES = 0.8e6
_FRAMES = 12  # of one body, at most
_GROUPS = 24  # of one test


_SIMULATION = ["problem", "name", "load", "further"]


@dataclass
class Group:
    """Cases of the same problem, which stand side by side."""

    label: str
    cases: list  # keys; springs first


def groups(study, test):
    """The groups of a test, the most telling first: springs beside finite elements, many
    methods, mss-cf among them, large loads; of those alike Poisson's ratios far apart. Only
    cases with an equilibrium's fields."""
    cases = study.with_fields(study.cases[study.cases.test == test])
    # The same simulation beside another reference looks alike: one that has frames, if there is one.
    has_none = pd.Series([not study.has(key, "frame_sample") for key in cases.index], cases.index, dtype=bool)
    first = cases.assign(has_none=has_none).sort_values("has_none", kind="stable")
    cases = cases[~first.duplicated(_SIMULATION).reindex(cases.index)]
    found = []
    for _, members in cases.groupby("problem", sort=False):
        members = members.sort_values(["kind", "name"], key=_order, kind="stable")
        kinds = set(members.kind)
        both = "finite elements" in kinds and len(kinds) > 1
        usable = members[(members.kind != "finite elements") & (members.status == "ok")]
        load = members.deformation.abs().max()
        rank = (
            not both,
            methods.of_thesis() not in set(usable["name"]),
            -(load if np.isfinite(load) else 0),
            -len(study.mesh(members.index[0])["nodes"]),
            -members.method.nunique(),
        )
        found.append((rank, members.nu.iloc[0], Group(group_text(members.iloc[0]), list(members.index))))
    found.sort(key=lambda entry: entry[0])
    ordered = []
    for _, alike in groupby(found, key=lambda entry: entry[0]):
        alike = list(alike)
        ordered += [alike[i][2] for i in far_apart([nu for _, nu, _ in alike], 0.25)]
    return ordered[:_GROUPS]


def far_apart(values, start):
    """Indices of numbers: the nearest to the start, then always the farthest from those before."""
    values = np.asarray(values, dtype=float)
    order = [int(np.abs(values - start).argmin())]
    distance = np.abs(values - values[order[0]])
    for _ in values[1:]:
        distance[order] = -1
        order.append(int(distance.argmax()))
        distance = np.minimum(distance, np.abs(values - values[order[-1]]))
    return order


def group_text(case):
    return case_text(case).removeprefix(f"{case.scene}, ")


def _order(column):
    ranks = {"springs": 0, "measured": 1, "finite elements": 2}
    return column.map(ranks) if column.name == "kind" else column


@dataclass
class _Numbers:
    """Numbers of four bytes each, little-endian, one array after the other. first: numbers
    before them."""

    first: int = 0
    parts: list = field(default_factory=list)
    count: int = 0

    def add(self, values, kind):
        """[place, count] of the array."""
        own = np.ascontiguousarray(values, dtype=kind)
        self.parts.append(own.tobytes())
        self.count += own.size
        return [self.first + self.count - own.size, own.size]

    def further(self):
        """Numbers that may come behind these."""
        return _Numbers(self.first + self.count)

    def append(self, further):
        self.parts += further.parts
        self.count += further.count

    def packed_size(self):
        return len(zlib.compress(b"".join(self.parts)))


def view_data(study, tests):
    """header: {meshes: {name: ...}, tests: {test: [group, ...]}} for the script, with places in
    data: surfaces in float32 and uint32. Groups beyond the budget are left out, of all tests
    in turn; left_out: how many. without_way: bodies whose frames are left out likewise."""
    meshes, views, left_out, without_way = {}, {test: [] for test in tests}, 0, 0
    numbers, room, room_of_frames = _Numbers(), _BUDGET, _BUDGET_OF_FRAMES
    surfaces = {}
    same = _same_simulations(study.cases)
    queues = {test: groups(study, test) for test in tests}
    while any(queues.values()):
        for test, queue in queues.items():
            if not queue:
                continue
            group = queue.pop(0)
            mesh_name = study.cases.loc[group.cases[0], "mesh"]
            if mesh_name not in surfaces:
                surfaces[mesh_name] = outside(study.mesh(group.cases[0]))
            surface, own = surfaces[mesh_name], numbers.further()
            new_mesh = {} if mesh_name in meshes else _mesh(study.mesh(group.cases[0]), surface, own)
            view = _group(study, group, same, surface, own)
            size = own.packed_size()
            if size > room:
                left_out += 1
                continue
            room -= size
            numbers.append(own)
            meshes.update({mesh_name: new_mesh} if new_mesh else {})
            for key, body in zip(group.cases, view["bodies"]):
                frames = numbers.further()
                way = _way(study, key, surface, frames)
                size = frames.packed_size()
                if way and size > room_of_frames:
                    without_way += 1
                elif way:
                    room_of_frames -= size
                    numbers.append(frames)
                    body.update(way)
            views[test].append(view)
    return {
        "header": {"meshes": meshes, "tests": views},
        "data": b"".join(numbers.parts),
        "left_out": left_out,
        "without_way": without_way,
    }


def _same_simulations(cases):
    """Keys of all cases of the same simulation, whatever their references, by each of them."""
    alike = cases.groupby(_SIMULATION, sort=False, dropna=False)
    return {key: list(keys) for keys in alike.groups.values() for key in keys}


def _group(study, group, same, surface, numbers):
    bodies = []
    usual = methods.of_thesis(), f"{methods.reference_law()}:q1-sri"
    for key in group.cases:
        case = study.cases.loc[key]
        displacement, ratio = study.field(key, "displacement"), study.field(key, "cell_volume_ratio")
        bodies.append(
            {
                "cases": same[key],
                "name": case["name"],
                "kind": case["kind"],
                "status": case["status"],
                "is_usual": case["name"] in usual,
                **_state(study.mesh(key), displacement, ratio, surface, numbers),
                "end": {},
                "frames": [],
            }
        )
    return {"label": group.label, "mesh": study.cases.loc[group.cases[0], "mesh"], "bodies": bodies}


def _state(mesh, displacement, volume_ratio, surface, numbers):
    strain = equivalent_strains(mesh, displacement)
    return {
        "displacement": numbers.add(displacement[surface.nodes], "<f4"),
        "strain": numbers.add(strain[surface.cells], "<f4"),
        "volume": numbers.add(volume_ratio[surface.cells] - 1, "<f4"),
    }


def _way(study, key, surface, numbers):
    """The body's frames and when it ends, evenly of what the file has; {} where it has none.
    What is not finite, or has flown beyond a thousand times its size, nobody could look at."""
    history, mesh = study.history(key), study.mesh(key)
    if history is None:
        return {}
    farthest = 1e3 * np.ptp(mesh["nodes"], axis=0).max()
    frames = [frame for frame in study.frames(key) if frame.sample < len(history) - 1]  # the last is the end
    frames = [frame for frame in frames[:: -(-len(frames) // _FRAMES) or 1] if np.abs(frame.displacement).max() < farthest]
    shown = [
        {**_state(mesh, frame.displacement, frame.cell_volume_ratio, surface, numbers), **_moment(history.iloc[frame.sample])}
        for frame in frames
    ]
    return {"end": _moment(history.iloc[-1]), "frames": shown} if shown else {}


def _moment(sample):
    return {"time": float(sample.time), "load": float(sample.load_fraction)}


def _mesh(mesh, surface, numbers):
    triangles, faces = surface.triangles()
    return {
        "nodes": numbers.add(mesh["nodes"][surface.nodes], "<f4"),
        "triangles": numbers.add(triangles, "<u4"),
        "faces": numbers.add(faces, "<u4"),
        "edges": numbers.add(surface.edges(), "<u4"),
    }
