"""Bodies for the 3D views: which cases, and their surfaces as the page's script reads them."""

from dataclasses import dataclass, field
from itertools import groupby

import methods
import numpy as np
from study import case_text
from strains import equivalent_strains
from surface import outside

# Bytes of all views together, packed to less than half of them: pages stay below 15 MB. Some
# are kept for what was recorded on the way.
_BUDGET = 9e6
_BUDGET_OF_FRAMES = 2e6
_GROUPS = 24  # of one test


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
    cases = cases[~cases.is_repeated]
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
    """Numbers of four bytes each, little-endian, one array after the other."""

    parts: list = field(default_factory=list)
    count: int = 0

    def add(self, values, kind):
        """[place, count] of the array."""
        own = np.ascontiguousarray(values, dtype=kind)
        self.parts.append(own.tobytes())
        self.count += own.size
        return [self.count - own.size, own.size]


def view_data(study, tests):
    """header: {meshes: {name: ...}, tests: {test: [group, ...]}} for the script, with places in
    data: surfaces in float32 and uint32. Groups beyond the budget are left out, of all tests
    in turn; left_out: how many."""
    meshes, views, left_out = {}, {test: [] for test in tests}, 0
    numbers, bytes_of_frames = _Numbers(), 0
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
            surface = surfaces[mesh_name]
            size_of_state = len(surface.nodes) * 12 + len(surface.faces) * 8
            size = size_of_state * len(group.cases)
            if 4 * numbers.count - bytes_of_frames + size > _BUDGET - _BUDGET_OF_FRAMES:
                left_out += 1
                continue
            if mesh_name not in meshes:
                meshes[mesh_name] = _mesh(study.mesh(group.cases[0]), surface, numbers)
            frames = {key: study.frames(key) for key in group.cases}
            size = size_of_state * sum(len(own) for own in frames.values())
            if bytes_of_frames + size > _BUDGET_OF_FRAMES:
                frames = {key: [] for key in group.cases}
            else:
                bytes_of_frames += size
            views[test].append(_group(study, group, same, frames, surface, numbers))
    header = {"meshes": meshes, "tests": views}
    return {"header": header, "data": b"".join(numbers.parts), "left_out": left_out}


def _same_simulations(cases):
    """Keys of all cases of the same simulation, whatever their references, by each of them."""
    alike = cases.groupby(["problem", "name", "load", "further"], sort=False, dropna=False)
    return {key: list(keys) for keys in alike.groups.values() for key in keys}


def _group(study, group, same, frames, surface, numbers):
    bodies = []
    usual = methods.of_thesis(), f"{methods.reference_law()}:q1-sri"
    mesh = study.mesh(group.cases[0])

    def state(displacement, volume_ratio):
        strain = equivalent_strains(mesh, displacement)
        return {
            "displacement": numbers.add(displacement[surface.nodes], "<f4"),
            "strain": numbers.add(strain[surface.cells], "<f4"),
            "volume": numbers.add(volume_ratio[surface.cells] - 1, "<f4"),
        }

    for key in group.cases:
        case = study.cases.loc[key]
        end = state(study.field(key, "displacement"), study.field(key, "cell_volume_ratio"))
        history = study.history(key) if frames[key] else None
        on_the_way = [
            {**state(frame.displacement, frame.cell_volume_ratio), **_moment(history.iloc[frame.sample])}
            for frame in frames[key]
            if frame.sample < len(history) - 1  # the last is the end
        ]
        bodies.append(
            {
                "cases": same[key],
                "name": case["name"],
                "kind": case["kind"],
                "status": case["status"],
                "is_usual": case["name"] in usual,
                **end,
                "end": _moment(history.iloc[-1]) if on_the_way else {},
                "frames": on_the_way,
            }
        )
    return {"label": group.label, "mesh": study.cases.loc[group.cases[0], "mesh"], "bodies": bodies}


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
