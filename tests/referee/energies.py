"""Energies on blocks of equal cells, with first and second derivatives.

All follow from stretches s = |g . X| of a cell, X its corners (8, 3) and g a vector of
eight numbers: of a spring, +1 and -1; of a virtual spring along n, the mean gradient
times n. Sources: Golec 2018, chapter 5; Flanagan and Belytschko 1981 for the mean
gradient; docs/explanation/models.md for what is the project's own.
"""

from dataclasses import dataclass
from typing import Callable

import numpy as np
import scipy.sparse as sparse
from blocks import Block, gauss_gradients


def mean_edges(block):
    """G (8, 3): the mean gradient of a cell, which is that at its centre."""
    return gauss_gradients(block.edges)[0].mean(axis=0)


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
