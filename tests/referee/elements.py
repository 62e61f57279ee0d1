"""Trilinear and triquadratic hexahedra of several laws on blocks of equal cells.

Stresses alone are written out; tangents are central differences, which Newton's method
needs no better.
"""

from dataclasses import dataclass
from typing import Callable

import laws
import numpy as np
from blocks import Block, gauss_gradients
from energies import (Determinants, Volumes, linear_in_volume, logarithmic_volume,
                      mean_edges)
from laws import (IDENTITY, cauchy_born, deviator, kirchhoff_of_hencky, lattice_directions,
                  pull_of_springs, trace, transposed)
from springs import lame

STEP = 1e-6  # of central differences, of F and of an edge


def slopes(f, X, h):
    """Central differences of f by its arguments' last two axes, behind those of f."""
    columns = []
    for a in range(X.shape[-2]):
        for d in range(X.shape[-1]):
            there, back = X.copy(), X.copy()
            there[..., a, d] += h
            back[..., a, d] -= h
            columns.append((f(there) - f(back)) / (2 * h))
    found = np.stack(columns, axis=-1)
    return found.reshape(*found.shape[:-1], *X.shape[-2:])


def slopes_by_nodes(cell_gradient, block, x):
    """Of gradients of cells by their own nodes, a symmetric matrix for each."""
    X = x[block.cell_nodes]
    H = slopes(cell_gradient, X, STEP * block.edges.min()).reshape(len(X), X[0].size, -1)
    return (H + H.transpose(0, 2, 1)) / 2


def quadrature(block):
    """Gradients at Gauss points, (points, nodes of a cell, 3), and the same times the
    volume of each point."""
    B, weights = gauss_gradients(block.edges, block.degree)
    return B, block.cell_volume * weights[:, None, None] * B


@dataclass
class AtPoints:
    """The first Piola-Kirchhoff stress P(F) at 2 x 2 x 2 points, or 3 x 3 x 3 of a block
    of degree 2."""

    block: Block
    P: Callable

    def __post_init__(self):
        self.B, self.VB = quadrature(self.block)

    def deformation_gradients(self, x):
        return np.einsum("cad,qae->cqde", x[self.block.cell_nodes], self.B)

    def gradient(self, x):
        stress = self.P(self.deformation_gradients(x))
        return self.block.assembled(np.einsum("cqde,qae->cad", stress, self.VB))

    def hessian(self, x):
        F = self.deformation_gradients(x)
        moduli = slopes(self.P, F, STEP)
        H = np.einsum("qae,cqdekf,qbf->cadbk", self.VB, moduli, self.B, optimize=True)
        H = H.reshape(len(F), 3 * H.shape[1], -1)
        return self.block.assembled_matrix((H + H.transpose(0, 2, 1)) / 2)


def hooke(block, E, nu):
    """q1 or q2 of Hooke's law."""
    la, mu = lame(E, nu)

    def P(F):
        strain = (F + transposed(F)) / 2 - IDENTITY
        return 2 * mu * strain + la * trace(strain)[..., None, None] * IDENTITY

    return [AtPoints(block, P)]


def st_venant_kirchhoff(block, E, nu):
    """q1 or q2 of lambda/2 (tr E)^2 + mu E : E."""
    la, mu = lame(E, nu)

    def P(F):
        strain = (transposed(F) @ F - IDENTITY) / 2
        return F @ (2 * mu * strain + la * trace(strain)[..., None, None] * IDENTITY)

    return [AtPoints(block, P)]


def hencky(block, E, nu):
    """q1 or q2 of mu |dev ln V|^2 + K/2 ln^2 J."""
    la, mu = lame(E, nu)
    return [AtPoints(block, laws.hencky(mu, la + 2 * mu / 3))]


@dataclass
class Means:
    """One plus the mean over each cell of a measure t(F) of volume, given with dt/dF."""

    block: Block
    measure: Callable

    def __post_init__(self):
        self.B, self.weights = gauss_gradients(self.block.edges, self.block.degree)

    def at_points(self, X):
        return self.measure(np.einsum("cad,qae->cqde", X, self.B))

    def value(self, x):
        return 1 + self.at_points(x[self.block.cell_nodes])[0] @ self.weights

    def slopes_at(self, X):
        weighted = self.weights[:, None, None] * self.B
        return np.einsum("cqde,qae->cad", self.at_points(X)[1], weighted)

    def slopes(self, x):
        return self.slopes_at(x[self.block.cell_nodes])

    def curvatures(self, x):
        return slopes_by_nodes(self.slopes_at, self.block, x)


def small_strain_trace(F):
    return trace(F) - 3, np.broadcast_to(IDENTITY, F.shape)


def green_strain_trace(F):
    return ((F**2).sum(axis=(-2, -1)) - 3) / 2, F


def change_of_volume(F):
    J = np.linalg.det(F)
    return J - 1, J[..., None, None] * transposed(np.linalg.inv(F))


def parted(block, E, nu, shape_stress, measure, volumetric, averaged):
    """The part of a law that resists change of shape at the cells' points, P = 2 mu
    times `shape_stress(F)`, and U, with the bulk modulus, of the mean of `measure`: over
    each cell (averaged = Volumes, q1-sri) or around each node (Stars, q1-nodal)."""
    la, mu = lame(E, nu)
    return [AtPoints(block, lambda F: 2 * mu * shape_stress(F)),
            averaged(Means(block, measure), volumetric(la + 2 * mu / 3))]


def hooke_parted(block, E, nu, averaged=Volumes):
    """mu |dev eps|^2 and K/2 (tr eps)^2."""
    return parted(block, E, nu, lambda F: deviator((F + transposed(F)) / 2 - IDENTITY),
                  small_strain_trace, linear_in_volume, averaged)


def st_venant_kirchhoff_parted(block, E, nu, averaged=Volumes):
    """mu |dev E|^2 and K/2 (tr E)^2."""
    return parted(block, E, nu, lambda F: F @ deviator((transposed(F) @ F - IDENTITY) / 2),
                  green_strain_trace, linear_in_volume, averaged)


def hencky_parted(block, E, nu, averaged=Volumes):
    """mu |dev ln V|^2 and K/2 ln^2 of the volume over that at rest."""
    return parted(block, E, nu, lambda F: deviator(kirchhoff_of_hencky(0.5, F)) @ transposed(
                      np.linalg.inv(F)), change_of_volume, logarithmic_volume, averaged)


def continuum_of_lattice(block, E, nu):
    """q1 or q2 of mss-cf's continuum, A = 1."""
    return [AtPoints(block, cauchy_born(E, nu, *lattice_directions(1)))]


def continuum_of_lattice_parted(block, E, nu, averaged=Volumes):
    """The springs at 2 x 2 x 2 points, and kappa/2 (J - 1)^2 with J = det F at each cell's
    centre (q1-sri) or the mean of det F around each node (q1-nodal)."""
    la, mu = lame(E, nu)
    n, weights = lattice_directions(1)
    J = (Determinants(block, mean_edges(block)) if averaged is Volumes else
         Means(block, change_of_volume))
    return [AtPoints(block, lambda F: pull_of_springs(n, weights, mu, F)),
            averaged(J, linear_in_volume(la - mu))]
