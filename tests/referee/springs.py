"""Energies of springs on blocks of equal cells, with first and second derivatives.

All follow from stretches s = |g . X| of a cell, X its corners (8, 3) and g a vector of
eight numbers: of a spring, +1 and -1; of a virtual spring along n, the mean gradient
times n. Sources: Golec 2018, chapter 5, with the constants of the shear modulus;
Flanagan and Belytschko 1981 for the mean gradient; docs/explanation/models.md for what is
the project's own. Which stiffness the hourglass springs of mss-affine have and which axes
its virtual ones is a choice, not a formula: those are taken over from
mss/networks/hourglass.hpp and axes.hpp, and a wrong choice is not seen here.
"""

from dataclasses import dataclass
from typing import Callable

import numpy as np
import scipy.sparse as sparse

from blocks import CORNERS, Block, gauss_gradients


def lame(E, nu):
    return E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))


@dataclass
class Stretches:
    """Sum over cells and rows m of f_m(q), q = |g_m . X| - |r_m . X| (without r: of one).

    f(q) gives value, first and second derivative, of arrays (cells, m)."""

    block: Block
    g: np.ndarray
    f: Callable
    r: np.ndarray = None

    def stretches(self, x):
        """Sign, vectors, lengths and directions of each of the two."""
        X = x[self.block.cell_nodes]
        for sign, g in ((1.0, self.g), (-1.0, self.r)):
            if g is None:
                continue
            y = np.einsum("ma,cad->cmd", g, X)
            s = np.linalg.norm(y, axis=2)
            yield sign, g, s, y / s[:, :, None]

    def elongation(self, x):
        return sum(sign * s for sign, _, s, _ in self.stretches(x))

    def slopes(self, x):
        """dq/dX, (cells, m, 8, 3)."""
        return sum(sign * np.einsum("ma,cmd->cmad", g, n) for sign, g, _, n in self.stretches(x))

    def energy(self, x):
        return float(self.f(self.elongation(x))[0].sum())

    def gradient(self, x):
        first = self.f(self.elongation(x))[1]
        return self.block.assembled(np.einsum("cm,cmad->cad", first, self.slopes(x)))

    def hessian(self, x):
        _, first, second = self.f(self.elongation(x))
        cells = len(first)
        slopes = self.slopes(x).reshape(cells, -1, 24)
        H = np.matmul(np.swapaxes(slopes * second[:, :, None], 1, 2), slopes)
        for sign, g, s, n in self.stretches(x):
            across = (np.eye(3) - n[:, :, :, None] * n[:, :, None, :])
            across *= (sign * first / s)[:, :, None, None]
            pairs = (g[:, :, None] * g[:, None, :]).reshape(len(g), 64)
            curved = np.tensordot(across.reshape(cells, -1, 9), pairs, axes=(1, 0))
            H += curved.reshape(cells, 3, 3, 8, 8).transpose(0, 3, 1, 4, 2).reshape(H.shape)
        return self.block.assembled_matrix(H)


class Determinants:
    """J = det(G . X) of each cell, G of shape (8, 3), one at rest; its derivatives."""

    def __init__(self, block, G):
        self.block, self.G = block, G

    def value(self, x):
        return np.linalg.det(self.columns(x))

    def columns(self, x):
        return np.einsum("cad,ae->cde", x[self.block.cell_nodes], self.G)

    def cofactors(self, x):
        y = self.columns(x)
        return np.stack([np.cross(y[:, :, (e + 1) % 3], y[:, :, (e + 2) % 3])
                         for e in range(3)], axis=2)

    def slopes(self, x):
        return np.einsum("ae,cde->cad", self.G, self.cofactors(x))

    def curvatures(self, x):
        """d2J/dX2, (cells, 24, 24)."""
        y = self.columns(x)
        H = np.zeros((len(y), 8, 3, 8, 3))
        for e in range(3):
            for f in range(3):
                if e == f:
                    continue
                third = y[:, :, 3 - e - f]
                sign = 1.0 if f == (e + 1) % 3 else -1.0
                # d(y_f x y_third)/dy_f: w -> w x y_third; and the other way round
                product = np.zeros((len(y), 3, 3))
                for k, (i, j) in enumerate(((1, 2), (2, 0), (0, 1))):
                    product[:, i, j], product[:, j, i] = third[:, k], -third[:, k]
                H += sign * np.einsum("a,b,ckl->cakbl", self.G[:, e], self.G[:, f], product)
        return H.reshape(len(y), 24, 24)


@dataclass
class Volumes:
    """V0 U(J) of each cell of degree 1, J what `measure` has of it, one at rest; U gives
    value and derivatives."""

    measure: object
    U: Callable

    def energy(self, x):
        block = self.measure.block
        return float(block.cell_volume * self.U(self.measure.value(x))[0].sum())

    def gradient(self, x):
        d = self.measure
        first = d.block.cell_volume * self.U(d.value(x))[1]
        return d.block.assembled(first[:, None, None] * d.slopes(x))

    def hessian(self, x):
        d = self.measure
        _, first, second = (d.block.cell_volume * u for u in self.U(d.value(x)))
        slopes = d.slopes(x).reshape(-1, 24)
        return d.block.assembled_matrix(
            second[:, None, None] * slopes[:, :, None] * slopes[:, None, :] +
            first[:, None, None] * d.curvatures(x))


@dataclass
class Stars:
    """Sum over nodes of V_n U(J_n), J_n the mean of J over the cells at the node, of
    degree 1, V_n an eighth of their volumes."""

    measure: object
    U: Callable

    def __post_init__(self):
        block = self.measure.block
        cells = np.repeat(np.arange(len(block.cell_nodes)), 8)
        self.count = np.bincount(block.cell_nodes.ravel())
        shape = len(block.nodes), len(block.cell_nodes)
        self.sums = sparse.csr_matrix((np.ones(len(cells)), (block.cell_nodes.ravel(), cells)),
                                      shape=shape)
        self.volumes = block.cell_volume / 8 * self.count

    def mean(self, values):
        return self.sums @ values / self.count

    def of_nodes(self, x):
        """V_n U and its derivatives."""
        return [self.volumes * u for u in self.U(self.mean(self.measure.value(x)))]

    def by_cell(self, x):
        """dW/dJ of the cells."""
        return self.sums.T @ (self.of_nodes(x)[1] / self.count)

    def energy(self, x):
        return float(self.of_nodes(x)[0].sum())

    def gradient(self, x):
        d = self.measure
        return d.block.assembled(self.by_cell(x)[:, None, None] * d.slopes(x))

    def hessian(self, x):
        d = self.measure
        slopes, own = d.slopes(x).reshape(-1, 24), d.block.components()
        rows = np.repeat(np.arange(len(own)), 24)
        D = sparse.csr_matrix((slopes.ravel(), (rows, own.ravel())),
                              shape=(len(own), 3 * len(d.block.nodes)))
        means = sparse.diags(1 / self.count) @ self.sums @ D
        curved = d.block.assembled_matrix(self.by_cell(x)[:, None, None] * d.curvatures(x))
        return (means.T @ sparse.diags(self.of_nodes(x)[2]) @ means + curved).tocsc()


@dataclass
class Traces:
    """V0 kappa/2 (tr E)^2 of each cell, E Green's strain of the mean edges y."""

    block: Block
    G: np.ndarray
    kappa: float

    def trace_and_edges(self, x):
        y = np.einsum("cad,ae->cde", x[self.block.cell_nodes], self.G)
        return ((y**2).sum(axis=(1, 2)) - 3) / 2, y

    def energy(self, x):
        t, _ = self.trace_and_edges(x)
        return float(self.block.cell_volume * self.kappa / 2 * (t**2).sum())

    def slopes(self, y):
        return np.einsum("ae,cde->cad", self.G, y)

    def gradient(self, x):
        t, y = self.trace_and_edges(x)
        pull = self.block.cell_volume * self.kappa * t
        return self.block.assembled(pull[:, None, None] * self.slopes(y))

    def hessian(self, x):
        t, y = self.trace_and_edges(x)
        slopes = self.slopes(y).reshape(-1, 24)
        curved = np.einsum("ae,be,kl->akbl", self.G, self.G, np.eye(3)).reshape(24, 24)
        scale = self.block.cell_volume * self.kappa
        return self.block.assembled_matrix(
            scale * (slopes[:, :, None] * slopes[:, None, :] + t[:, None, None] * curved))


# ------------------------------------------------------------- functions of one value


def engineering(k, L):
    """k/2 (s - L)^2"""
    return lambda s: (k / 2 * (s - L)**2, k * (s - L), k + 0 * s)


def squared(k, L):
    """k (s^2 - L^2)^2/(8 L^2)"""
    return lambda s: (k * (s**2 - L**2)**2 / (8 * L**2), k * s * (s**2 - L**2) / (2 * L**2),
                      k * (3 * s**2 - L**2) / (2 * L**2))


def logarithmic(k, L):
    """k L^2/2 ln^2(s/L)"""
    return lambda s: (k * L**2 / 2 * np.log(s / L)**2, k * L**2 * np.log(s / L) / s,
                      k * L**2 * (1 - np.log(s / L)) / s**2)


def hencky(k, L, a=0.7, b=0.3):
    """s dW/ds = k L^2 (u - 1)/(2 u (a + b u)), u = (s/L)^2; no value."""

    def f(s):
        u = (s / L)**2
        pull = (u - 1) / (2 * u * (a + b * u))  # s W'/(k L^2)
        slope = 1 / (2 * u * (a + b * u)) - (u - 1) * (a + 2 * b * u) / (
            2 * (u * (a + b * u))**2)
        return np.nan * s, k * L**2 * pull / s, k * L**2 * (2 * u * slope - pull) / s**2

    return f


def linear_in_volume(kappa):
    return lambda J: (kappa / 2 * (J - 1)**2, kappa * (J - 1), kappa + 0 * J)


def logarithmic_volume(kappa, cubic=0.0):
    """kappa/2 ln^2 J + cubic ln^3(J)/3, J above 1/2"""
    return lambda J: (kappa / 2 * np.log(J)**2 + cubic * np.log(J)**3 / 3,
                      (kappa * np.log(J) + cubic * np.log(J)**2) / J,
                      (kappa + 2 * cubic * np.log(J) - kappa * np.log(J) -
                       cubic * np.log(J)**2) / J**2)


# --------------------------------------------------------------------------- methods


def cell_springs(edges):
    """Vectors (28, 8) and lengths of a cell's springs: pairs of corners; and how many
    of the three coordinates the two differ in."""
    pairs = [(a, b) for a in range(8) for b in range(a + 1, 8)]
    vectors = np.zeros((28, 8))
    for row, (a, b) in enumerate(pairs):
        vectors[row, a], vectors[row, b] = -1, 1
    differences = np.array([CORNERS[b] - CORNERS[a] for a, b in pairs])
    return vectors, np.linalg.norm(differences * edges, axis=1), np.abs(differences).sum(axis=1)


def mean_edges(block):
    """G (8, 3): the mean gradient of a cell, which is that at its centre."""
    return gauss_gradients(block.edges)[0].mean(axis=0)


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
