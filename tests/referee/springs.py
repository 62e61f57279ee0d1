"""Springs on blocks of equal cells: which ones a method has, how stiff they are, and which
correction of volume goes with them; dashpots along them.

Sources: Golec 2018, chapter 5, with the constants of the shear modulus;
docs/explanation/models.md for what is the project's own. Which stiffness the hourglass
springs of mss-affine have and which axes its virtual ones is a choice, not a formula:
those are taken over from mss/networks/hourglass.hpp and axes.hpp, and a wrong choice is
not seen here.
"""

import numpy as np
import scipy.sparse as sparse
from blocks import CORNERS
from energies import (Determinants, Stars, Stretches, Traces, Volumes, engineering, hencky,
                      linear_in_volume, logarithmic, logarithmic_volume, mean_edges, squared)


def lame(E, nu):
    return E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))


def cell_springs(edges):
    """Vectors (28, 8) and lengths of a cell's springs: pairs of corners; and how many
    of the three coordinates the two differ in."""
    pairs = [(a, b) for a in range(8) for b in range(a + 1, 8)]
    vectors = np.zeros((28, 8))
    for row, (a, b) in enumerate(pairs):
        vectors[row, a], vectors[row, b] = -1, 1
    differences = np.array([CORNERS[b] - CORNERS[a] for a, b in pairs])
    return vectors, np.linalg.norm(differences * edges, axis=1), np.abs(differences).sum(axis=1)


def kappa_of(E, nu):
    return E * (4 * nu - 1) / (2 * (1 + nu) * (1 - 2 * nu))


def constants(h, E, nu, A, form="mu"):
    """k_e, k_f, k_c of the lattice [N/m]; form E is what the thesis prints (Eq. 5.12),
    right at nu = 1/4 alone: mu taken for 2 E/5."""
    mu = lame(E, nu)[1] if form == "mu" else 2 * E / 5
    k_c = 3 * mu * h / (3 * A + 4)
    return A * k_c + 8 / 3 * k_c, A * k_c, k_c


def stiffness_of_cell_springs(method, h, E, nu, form="mu", A=None):
    """Of the 28 springs of one cell by the coordinates they differ in: a quarter of an
    edge's, half of a face's diagonal, an inner diagonal whole."""
    if method == "mss-baudet":
        edge = E * h * (4 * nu + 1) / (8 * (1 + nu))
        return np.array([np.nan, edge, 0, 3 * E * h / (8 * (1 + nu))])
    if A is None:
        A = 0 if method == "mss-nfd" else 1
    k_e, k_f, k_c = constants(h, E, nu, A, form)
    return np.array([np.nan, k_e / 4, k_f / 2, k_c])


def lattice(block, method, E, nu, form="mu", measure="engineering", A=None):
    """Springs of cubes and, but for mss-baudet and mss-fd, the correction of volume."""
    h = block.edges[0]
    vectors, L, apart = cell_springs(block.edges)
    k = stiffness_of_cell_springs(method, h, E, nu, form, A)[apart]
    there = k > 0
    law = {"engineering": engineering, "green": squared, "logarithmic": logarithmic,
           "hencky": hencky}[measure]
    parts = [Stretches(block, vectors[there], law(k[there], L[there]))]
    kappa = kappa_of(E, nu)
    if method in ("mss-baudet", "mss-fd"):
        return parts
    if measure == "green":
        return parts + [Traces(block, mean_edges(block), kappa)]
    U = {"engineering": linear_in_volume(kappa), "logarithmic": logarithmic_volume(kappa),
         "hencky": logarithmic_volume(kappa, lame(E, nu)[1])}[measure]
    return parts + [Volumes(Determinants(block, mean_edges(block)), U)]


def cyclic(*vectors):
    return [v[i:] + v[:i] for v in vectors for i in range(3)]


def icosahedron():
    """Its six axes."""
    golden = (1 + np.sqrt(5)) / 2
    axes = np.array(cyclic((golden, 1, 0), (golden, -1, 0)))
    return axes / np.linalg.norm(axes, axis=1)[:, None]


def sixteen_axes():
    """Of the icosahedron and the dodecahedron dual to it, and their weights in the mean
    over directions."""
    golden = (1 + np.sqrt(5)) / 2
    corners = np.array([(1, 1, 1), (1, 1, -1), (1, -1, 1), (-1, 1, 1)] +
                       cyclic((0, 1 / golden, golden), (0, -1 / golden, golden)))
    return (np.vstack([icosahedron(), corners / np.sqrt(3)]),
            np.array([25 / 420] * 6 + [27 / 420] * 10))


def affine(block, E, nu, stars=None):
    """mss-affine on cubes: sixteen virtual springs, kappa on cells up to nu = 1/4 and on
    stars above unless said, hourglass springs whose rest length follows the mean
    gradient."""
    G, V = mean_edges(block), block.cell_volume
    _, mu = lame(E, nu)
    n, weights = sixteen_axes()
    parts = [Stretches(block, n @ G.T, engineering(15 * mu * V * weights, 1.0))]
    kappa, J = kappa_of(E, nu), Determinants(block, G)
    if stars is None:
        stars = nu > 0.25
    parts.append((Stars if stars else Volumes)(J, linear_in_volume(kappa)))
    vectors, L, apart = cell_springs(block.edges)
    m = 0.843 / (2 * (1 + nu))
    eta = np.array([np.nan, ((1 + np.sqrt(1 + 4 * m * m)) / 2 - m) / 12, m / 3, 0])[apart]
    k = eta * E * V / L**2
    there = k > 0
    ends = vectors[there] @ (CORNERS * block.edges)  # (m, 3): r at rest
    parts.append(Stretches(block, vectors[there],
                           lambda q: (k[there] / 2 * q**2, k[there] * q, k[there] + 0 * q),
                           r=ends @ G.T))
    return parts


# ---------------------------------------------------------------------------- motion


def whole_springs(block, method, E, nu):
    """Of a lattice: ends (springs, 2), stiffness and length at rest of each."""
    vectors, _, apart = cell_springs(block.edges)
    by_kind = stiffness_of_cell_springs(method, block.edges[0], E, nu)
    pairs, shares = [], []
    for row, kind in enumerate(apart):
        if by_kind[kind] > 0:
            pairs.append(np.sort(block.cell_nodes[:, np.flatnonzero(vectors[row])], axis=1))
            shares.append(np.full(len(block.cell_nodes), by_kind[kind]))
    ends, spring = np.unique(np.vstack(pairs), axis=0, return_inverse=True)
    along = block.nodes[ends[:, 1]] - block.nodes[ends[:, 0]]
    return ends, np.bincount(spring.ravel(), np.concatenate(shares)), np.linalg.norm(along, axis=1)


def dashpots(block, method, E, nu, masses, zeta):
    """The sparse matrix C of dashpots c = 2 zeta sqrt(k m1 m2/(m1 + m2)) along the
    springs."""
    ends, k, L = whole_springs(block, method, E, nu)
    m1, m2 = masses[ends[:, 0]], masses[ends[:, 1]]
    c = 2 * zeta * np.sqrt(k * m1 * m2 / (m1 + m2))
    along = (block.nodes[ends[:, 1]] - block.nodes[ends[:, 0]]) / L[:, None]
    rows = np.repeat(np.arange(len(ends)), 6)
    columns = (3 * ends[:, :, None] + np.arange(3)).reshape(len(ends), 6)
    D = sparse.csr_matrix((np.hstack([-along, along]).ravel(), (rows, columns.ravel())),
                          shape=(len(ends), 3 * len(block.nodes)))
    return (D.T @ sparse.diags(c) @ D).tocsc()
