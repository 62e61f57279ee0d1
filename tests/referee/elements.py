"""Trilinear hexahedra of several laws on blocks of equal cells.

Their gradient alone is written out; the tangent is its central difference, which Newton's
method needs no better.
"""

from dataclasses import dataclass
from typing import Callable

import numpy as np
from blocks import Block, gauss_gradients
from laws import (IDENTITY, cauchy_born, deviator, kirchhoff_of_hencky, lattice_directions,
                  pull_of_springs, trace, transposed)
from springs import Determinants, Volumes, lame, linear_in_volume, mean_edges


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
        tau = deviator(kirchhoff_of_hencky(mu, F))
        J = np.linalg.det(F)
        inverse = transposed(np.linalg.inv(F))
        mean = J.mean(axis=1)
        pressure = (K * np.log(mean) / mean)[:, None] * J
        P = (tau + pressure[..., None, None] * IDENTITY) @ inverse
        return V * np.einsum("cqde,qae->cad", P, B)

    return [Elements(block, gradient)]


def continuum_of_lattice(block, E, nu):
    """q1 of mss-cf's continuum, A = 1."""
    return full(block, cauchy_born(E, nu, *lattice_directions(1)))


def continuum_of_lattice_reduced(block, E, nu):
    """q1-sri: the springs at 2 x 2 x 2 points, kappa/2 (det F - 1)^2 at the centre."""
    la, mu = lame(E, nu)
    n, weights = lattice_directions(1)
    volume = Volumes(Determinants(block, mean_edges(block)), linear_in_volume(la - mu))
    return full(block, lambda F: pull_of_springs(n, weights, mu, F)) + [volume]
