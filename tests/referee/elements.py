"""Trilinear hexahedra and laws of continua on blocks of equal cells, and bars of laws.

Every part has its gradient alone written out; the tangent is its central difference,
which Newton's method needs no better.
"""

from dataclasses import dataclass
from typing import Callable

import numpy as np
from blocks import Block, gauss_gradients
from springs import (Determinants, Volumes, icosahedron, lame, linear_in_volume,
                     mean_edges)

IDENTITY = np.eye(3)


@dataclass
class Elements:
    """cell_gradient(X) of corners X (cells, 8, 3)."""

    block: Block
    cell_gradient: Callable

    def gradient(self, x):
        return self.block.assembled(self.cell_gradient(x[self.block.corners]))

    def hessian(self, x, step=1e-6):
        X = x[self.block.corners]
        H = np.zeros((len(X), 24, 24))
        h = step * self.block.edges.min()
        for a in range(8):
            for d in range(3):
                there, back = X.copy(), X.copy()
                there[:, a, d] += h
                back[:, a, d] -= h
                slope = self.cell_gradient(there) - self.cell_gradient(back)
                H[:, :, 3 * a + d] = (slope / (2 * h)).reshape(-1, 24)
        return self.block.assembled_matrix((H + H.transpose(0, 2, 1)) / 2)


def trace(A):
    return np.trace(A, axis1=-2, axis2=-1)


def deviator(A):
    return A - trace(A)[..., None, None] * IDENTITY / 3


def transposed(A):
    return np.swapaxes(A, -1, -2)


def quadrature(block):
    """Gradients at 2 x 2 x 2 points, (8, 8, 3), and the volume of each point."""
    return gauss_gradients(block.edges), block.cell_volume / 8


def full(block, P):
    """q1: the first Piola-Kirchhoff stress P(F) at 2 x 2 x 2 points."""
    B, V = quadrature(block)

    def gradient(X):
        F = np.einsum("cad,qae->cqde", X, B)
        return V * np.einsum("cqde,qae->cad", P(F), B)

    return [Elements(block, gradient)]


def hooke(block, E, nu):
    """q1 of Hooke's law."""
    la, mu = lame(E, nu)

    def P(F):
        strain = (F + transposed(F)) / 2 - IDENTITY
        return 2 * mu * strain + la * trace(strain)[..., None, None] * IDENTITY

    return full(block, P)


def hooke_reduced(block, E, nu):
    """q1-sri: 2 mu dev(eps) at 2 x 2 x 2 points, K tr(eps) at the centre."""
    la, mu = lame(E, nu)
    K = la + 2 * mu / 3
    B, V = quadrature(block)
    centre = B.mean(axis=0)

    def gradient(X):
        F = np.einsum("cad,qae->cqde", X, B)
        stress = 2 * mu * deviator((F + transposed(F)) / 2 - IDENTITY)
        pressure = K * (np.einsum("cad,ad->c", X, centre) - 3)
        return (V * np.einsum("cqde,qae->cad", stress, B) +
                8 * V * pressure[:, None, None] * centre)

    return [Elements(block, gradient)]


def st_venant_kirchhoff_reduced(block, E, nu):
    """q1-sri: mu dev E : dev E at 2 x 2 x 2 points, V K/2 (mean of tr E)^2."""
    la, mu = lame(E, nu)
    K = la + 2 * mu / 3
    B, V = quadrature(block)

    def gradient(X):
        F = np.einsum("cad,qae->cqde", X, B)
        strain = (transposed(F) @ F - IDENTITY) / 2
        mean = trace(strain).mean(axis=1)
        S = 2 * mu * deviator(strain) + K * mean[:, None, None, None] * IDENTITY
        return V * np.einsum("cqde,qae->cad", F @ S, B)

    return [Elements(block, gradient)]


def st_venant_kirchhoff(block, E, nu):
    """q1 of lambda/2 (tr E)^2 + mu E : E."""
    la, mu = lame(E, nu)

    def P(F):
        strain = (transposed(F) @ F - IDENTITY) / 2
        return F @ (2 * mu * strain + la * trace(strain)[..., None, None] * IDENTITY)

    return full(block, P)


def hencky_reduced(block, E, nu):
    """q1-sri: mu |dev ln V|^2 at 2 x 2 x 2 points, V K/2 ln^2 of the cell's volume
    over that at rest."""
    la, mu = lame(E, nu)
    K = la + 2 * mu / 3
    B, V = quadrature(block)

    def gradient(X):
        F = np.einsum("cad,qae->cqde", X, B)
        values, axes = np.linalg.eigh(F @ transposed(F))
        logarithms = np.log(values) / 2
        logarithms -= logarithms.mean(axis=-1, keepdims=True)
        tau = 2 * mu * (axes * logarithms[..., None, :]) @ transposed(axes)
        J = np.linalg.det(F)
        inverse = transposed(np.linalg.inv(F))
        mean = J.mean(axis=1)
        pressure = (K * np.log(mean) / mean)[:, None] * J
        P = (tau + pressure[..., None, None] * IDENTITY) @ inverse
        return V * np.einsum("cqde,qae->cad", P, B)

    return [Elements(block, gradient)]


# ------------------------------------------------------------------------------ bars


def lattice_directions(A):
    """Unit vectors of the cubic lattice's edges, face and inner diagonals, each line
    once, and for each sum k L^2 over a cell's volume, over mu."""
    edge = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    face = [(1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1), (0, 1, 1), (0, 1, -1)]
    inner = [(1, 1, 1), (1, 1, -1), (1, -1, 1), (-1, 1, 1)]
    k = 3 / (3 * A + 4)  # of mu h, inner diagonals
    weights = [(A + 8 / 3) * k] * 3 + [2 * A * k] * 6 + [3 * k] * 4
    n = np.array(edge + face + inner, dtype=float)
    return n / np.linalg.norm(n, axis=1)[:, None], np.array(weights)


def sixteen_axes():
    """Of icosahedron and dodecahedron together, weights of the mean over directions."""
    golden = (1 + np.sqrt(5)) / 2
    corners = [(1, 1, 1), (1, 1, -1), (1, -1, 1), (-1, 1, 1)]
    for a, b in ((1 / golden, golden), (-1 / golden, golden)):
        corners += [(a, 0, b), (0, b, a), (b, a, 0)]
    n = np.array(corners, dtype=float)
    return (np.vstack([icosahedron(), n / np.linalg.norm(n, axis=1)[:, None]]),
            np.array([25 / 420] * 6 + [27 / 420] * 10))


def pull_of_springs(n, weights, mu, F):
    """P of sum w mu/2 (|F n| - 1)^2, for F of any leading shape."""
    d = np.einsum("...ij,mj->...mi", F, n)
    s = np.linalg.norm(d, axis=-1)
    pull = mu * weights * (s - 1) / s
    return np.einsum("...m,...mi,mj->...ij", pull, d, n)


def cauchy_born(E, nu, n, weights):
    """P(F) of springs in directions n and kappa/2 (det F - 1)^2."""
    la, mu = lame(E, nu)

    def P(F):
        J = np.linalg.det(F)
        pressure = ((la - mu) * (J - 1) * J)[..., None, None]
        return pull_of_springs(n, weights, mu, F) + pressure * transposed(np.linalg.inv(F))

    return P


def continuum_of_lattice(block, E, nu):
    """q1 of mss-cf's continuum, A = 1."""
    return full(block, cauchy_born(E, nu, *lattice_directions(1)))


def continuum_of_lattice_reduced(block, E, nu):
    """q1-sri: the springs at 2 x 2 x 2 points, kappa/2 (det F - 1)^2 at the centre."""
    la, mu = lame(E, nu)
    n, weights = lattice_directions(1)
    volume = Volumes(Determinants(block, mean_edges(block)), linear_in_volume(la - mu))
    return full(block, lambda F: pull_of_springs(n, weights, mu, F)) + [volume]


def turn_to(direction):
    """Q that turns z into the direction."""
    along = np.array(direction, dtype=float)
    along /= np.linalg.norm(along)
    helper = np.array([0.0, 0, 1]) if abs(along[2]) < 0.9 else np.array([1.0, 0, 0])
    first = np.cross(helper, along)
    first /= np.linalg.norm(first)
    return np.column_stack([first, np.cross(along, first), along])


def bar_stress(P, direction, stretch):
    """Nominal stress of a bar along a direction of the lattice in uniaxial stress: the
    other components of F, symmetric up to the turn, by Newton's method."""
    Q = turn_to(direction)
    # F = stretch along z; unknown: the symmetric rest
    basis = [(0, 0), (1, 1), (0, 1), (0, 2), (1, 2)]

    def F_of(u):
        F = np.diag([1.0, 1.0, stretch])
        for value, (i, j) in zip(u, basis):
            F[i, j] += value
            if i != j:
                F[j, i] += value
        return F

    def stress(u):
        F = F_of(u)
        S = np.linalg.solve(F, Q.T @ P(Q @ F @ Q.T) @ Q)  # second Piola-Kirchhoff
        return np.array([S[i, j] for i, j in basis]), F @ S

    u = np.zeros(5)
    for _ in range(50):
        r, whole = stress(u)
        if np.abs(r).max() < 1e-12 * max(np.abs(whole).max(), 1):
            return whole[2, 2]
        K = np.column_stack([(stress(u + d)[0] - stress(u - d)[0]) / 2e-6
                             for d in 1e-6 * np.eye(5)])
        u = u - np.linalg.solve(K, r)
    raise AssertionError("no state of uniaxial stress")
