"""The outside of a mesh, for drawing."""

from dataclasses import dataclass

import numpy as np

_FACES = {
    "tetrahedra": [(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)],
    "pyramids": [(0, 1, 2, 3), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)],
    "prisms": [(0, 1, 2), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)],
    "hexahedra": [
        (0, 1, 2, 3),
        (4, 5, 6, 7),
        (0, 1, 5, 4),
        (1, 2, 6, 5),
        (2, 3, 7, 6),
        (3, 0, 4, 7),
    ],
}


@dataclass
class Surface:
    """nodes: numbers in the mesh of those on the outside. faces: rows of four places in
    `nodes`, outward; of triangles the last place twice. cells: of each face, its cell's
    place in fields of cells."""

    nodes: np.ndarray
    faces: np.ndarray
    cells: np.ndarray

    def edges(self):
        """Pairs of places in `nodes`, each edge once."""
        pairs = np.concatenate([self.faces[:, [i, (i + 1) % 4]] for i in range(4)])
        pairs = np.sort(pairs[pairs[:, 0] != pairs[:, 1]], axis=1)
        return np.unique(pairs, axis=0)

    def triangles(self):
        """(triples of places in `nodes`, place in `faces` of each)."""
        whole = self.faces[:, 2] != self.faces[:, 3]
        triples = np.concatenate([self.faces[:, [0, 1, 2]], self.faces[whole][:, [0, 2, 3]]])
        places = np.arange(len(self.faces))
        return triples, np.concatenate([places, places[whole]])


def outside(mesh):
    """The Surface of a mesh as springcheck_results.Results.mesh returns it: faces that
    belong to one cell."""
    faces, cells, centres = [], [], []
    first_cell = 0
    for name, local_faces in _FACES.items():
        if name not in mesh:
            continue
        nodes = mesh[name]
        numbers = np.arange(first_cell, first_cell + len(nodes))
        first_cell += len(nodes)
        centre = mesh["nodes"][nodes].mean(axis=1)
        for local in local_faces:
            four = local if len(local) == 4 else (*local, local[2])
            faces.append(nodes[:, four])
            cells.append(numbers)
            centres.append(centre)
    faces, cells, centres = (np.concatenate(parts) for parts in (faces, cells, centres))
    faces = faces.astype(np.int64)  # of files unsigned, which have no -1
    # A triangle repeats a node wherever it starts: sorted, that node is told by a -1.
    keys = np.sort(faces, axis=1)
    keys[:, 1:][keys[:, 1:] == keys[:, :-1]] = -1
    _, first, count = np.unique(
        np.sort(keys, axis=1), axis=0, return_index=True, return_counts=True
    )
    outer = np.sort(first[count == 1])
    faces, cells, centres = faces[outer].copy(), cells[outer], centres[outer]
    corner = mesh["nodes"][faces]
    normal = np.cross(corner[:, 2] - corner[:, 0], corner[:, 3] - corner[:, 1])
    inward = ((corner.mean(axis=1) - centres) * normal).sum(axis=1) < 0
    # Backwards, with the node that a triangle repeats still last: (a, b, c, c) -> (b, a, c, c).
    quads = faces[:, 2] != faces[:, 3]
    faces[inward & quads] = faces[inward & quads][:, [1, 0, 3, 2]]
    faces[inward & ~quads] = faces[inward & ~quads][:, [1, 0, 2, 3]]
    nodes, places = np.unique(faces, return_inverse=True)
    return Surface(nodes, places.reshape(faces.shape), cells)


_EDGES = {
    "tetrahedra": [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)],
    "pyramids": [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 4), (2, 4), (3, 4)],
    "prisms": [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)],
    "hexahedra": [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4)]
    + [(0, 4), (1, 5), (2, 6), (3, 7)],
}


def edges_in_plane(mesh, axis, position, tolerance):
    """Pairs of node numbers: edges of cells whose ends both lie in the plane where the
    undeformed coordinate `axis` is `position`, each once."""
    inside = np.abs(mesh["nodes"][:, axis] - position) < tolerance
    pairs = [mesh[name][:, pair] for name in _EDGES if name in mesh for pair in _EDGES[name]]
    pairs = np.sort(np.concatenate(pairs), axis=1)
    return np.unique(pairs[inside[pairs].all(axis=1)], axis=0)
