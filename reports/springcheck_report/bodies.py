"""Bodies for the 3D views: which cases, and their surfaces as the page's script reads them."""

import base64
from dataclasses import dataclass
from itertools import groupby


import methods
import numpy as np
from study import case_text
from surface import outside

# Bytes of all views together, before base64 makes a third more of them; pages stay below 25 MB with script and figures.
_BUDGET = 6e6
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


def view_data(study, tests):
    """{meshes: {name: ...}, tests: {test: [group, ...]}} for the script: surfaces in
    little-endian float32 and uint32, base64. Groups beyond the budget are left out, of all
    tests in turn; returns also how many."""
    meshes, views, spent, left_out = {}, {test: [] for test in tests}, 0, 0
    surfaces = {}
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
            size = len(surface.nodes) * 16 * len(group.cases) + len(surface.faces) * 6
            if spent + size > _BUDGET:
                left_out += 1
                continue
            spent += size
            if mesh_name not in meshes:
                meshes[mesh_name] = _mesh(study.mesh(group.cases[0]), surface)
            views[test].append(_group(study, group, mesh_name, surface))
    return {"meshes": meshes, "tests": views}, left_out


def _group(study, group, mesh_name, surface):
    bodies = []
    usual = methods.of_thesis(), f"{methods.reference_law()}:q1-sri"
    for key in group.cases:
        case = study.cases.loc[key]
        bodies.append(
            {
                "case": key,
                "name": case["name"],
                "kind": case["kind"],
                "status": case["status"],
                "is_usual": case["name"] in usual,
                "displacement": _packed(study.field(key, "displacement")[surface.nodes], "<f4"),
                "volume": _packed(study.field(key, "cell_volume_ratio")[surface.cells] - 1, "<f4"),
            }
        )
    return {"label": group.label, "mesh": mesh_name, "bodies": bodies}


def _mesh(mesh, surface):
    triangles, faces = surface.triangles()
    return {
        "nodes": _packed(mesh["nodes"][surface.nodes], "<f4"),
        "triangles": _packed(triangles, "<u4"),
        "faces": _packed(faces, "<u4"),
        "edges": _packed(surface.edges(), "<u4"),
    }


def _packed(values, kind):
    return base64.b64encode(np.ascontiguousarray(values, dtype=kind)).decode("ascii")
