"""Trilinear and triquadratic hexahedra of several laws on blocks of equal cells.

Stresses alone are written out; tangents are central differences, which Newton's method
needs no better.
"""

from dataclasses import dataclass
from typing import Callable

import laws
import numpy as np
from blocks import Block, gauss_gradients
from laws import (IDENTITY, cauchy_born, deviator, kirchhoff_of_hencky, lattice_directions,
                  pull_of_springs, trace, transposed)
from springs import (Determinants, Volumes, lame, linear_in_volume, logarithmic_volume,
                     mean_edges)


@dataclass
class Elements:
    """cell_gradient(X) of the cells' nodes X, (cells, nodes of each, 3)."""

    block: Block
    cell_gradient: Callable

    def gradient(self, x):
        return self.block.assembled(self.cell_gradient(x[self.block.of_cells]))

    def hessian(self, x, step=1e-6):
        X = x[self.block.of_cells]
        H = slopes_of(self.cell_gradient, X, step * self.block.edges.min())
        return self.block.assembled_matrix((H + H.transpose(0, 2, 1)) / 2)


def slopes_of(gradient, X, h):
    """Central differences of cells' gradients by their nodes X, a matrix for each."""
    size = X[0].size
    H = np.zeros((len(X), size, size))
    for a in range(X.shape[1]):
        for d in range(3):
            there, back = X.copy(), X.copy()
            there[:, a, d] += h
            back[:, a, d] -= h
            slope = gradient(there) - gradient(back)
            H[:, :, 3 * a + d] = (slope / (2 * h)).reshape(-1, size)
    return H


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
        return np.einsum("cad,qae->cqde", x[self.block.of_cells], self.B)

    def gradient(self, x):
        stress = self.P(self.deformation_gradients(x))
        return self.block.assembled(np.einsum("cqde,qae->cad", stress, self.VB))

    def hessian(self, x, step=1e-6):
        F = self.deformation_gradients(x)
        slopes = np.zeros((*F.shape, 3, 3))
        for k in range(3):
            for f in range(3):
                there, back = F.copy(), F.copy()
                there[..., k, f] += step
                back[..., k, f] -= step
                slopes[..., k, f] = (self.P(there) - self.P(back)) / (2 * step)
        H = np.einsum("qae,cqdekf,qbf->cadbk", self.VB, slopes, self.B, optimize=True)
        H = H.reshape(len(F), 3 * H.shape[1], -1)
        return self.block.assembled_matrix((H + H.transpose(0, 2, 1)) / 2)


def full(block, P):
    """q1, or q2 of a block of degree 2."""
    return [AtPoints(block, P)]


def hooke(block, E, nu):
    """q1 or q2 of Hooke's law."""
    la, mu = lame(E, nu)

    def P(F):
        strain = (F + transposed(F)) / 2 - IDENTITY
        return 2 * mu * strain + la * trace(strain)[..., None, None] * IDENTITY

    return full(block, P)


def st_venant_kirchhoff(block, E, nu):
    """q1 or q2 of lambda/2 (tr E)^2 + mu E : E."""
    la, mu = lame(E, nu)

    def P(F):
        strain = (transposed(F) @ F - IDENTITY) / 2
        return F @ (2 * mu * strain + la * trace(strain)[..., None, None] * IDENTITY)

    return full(block, P)


def hencky(block, E, nu):
    """q2 of mu |dev ln V|^2 + K/2 ln^2 J."""
    la, mu = lame(E, nu)
    return full(block, laws.hencky(mu, la + 2 * mu / 3))


@dataclass
class Means:
    """One and the mean over each cell's points of a measure t(F) of volume, given with
    dt/dF."""

    block: Block
    measure: Callable

    def __post_init__(self):
        self.B, VB = quadrature(self.block)
        self.weighted = VB / self.block.cell_volume

    def at_points(self, X):
        return self.measure(np.einsum("cad,qae->cqde", X, self.B))

    def value(self, x):
        return 1 + self.at_points(x[self.block.of_cells])[0].mean(axis=1)

    def slopes_at(self, X):
        return np.einsum("cqde,qae->cad", self.at_points(X)[1], self.weighted)

    def slopes(self, x):
        return self.slopes_at(x[self.block.of_cells])

    def curvatures(self, x):
        h = 1e-6 * self.block.edges.min()
        return slopes_of(self.slopes_at, x[self.block.of_cells], h)


def small_strain_trace(F):
    return trace(F) - 3, np.broadcast_to(IDENTITY, F.shape)


def green_strain_trace(F):
    return ((F**2).sum(axis=(-2, -1)) - 3) / 2, F


def change_of_volume(F):
    J = np.linalg.det(F)
    return J - 1, J[..., None, None] * transposed(np.linalg.inv(F))


def parted(block, E, nu, shape_stress, measure, volumetric, averaged):
    """The part of a law that resists change of shape at the cells' points, P = 2 mu
    times `shape_stress(F)`, and U of the bulk modulus of `measure`'s mean: over each cell
    (averaged = Volumes, q1-sri) or around each node (Stars, q1-nodal)."""
    la, mu = lame(E, nu)
    return full(block, lambda F: 2 * mu * shape_stress(F)) + [
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
    return full(block, cauchy_born(E, nu, *lattice_directions(1)))


def continuum_of_lattice_reduced(block, E, nu):
    """q1-sri: the springs at 2 x 2 x 2 points, kappa/2 (det F - 1)^2 at the centre."""
    la, mu = lame(E, nu)
    n, weights = lattice_directions(1)
    volume = Volumes(Determinants(block, mean_edges(block)), linear_in_volume(la - mu))
    return full(block, lambda F: pull_of_springs(n, weights, mu, F)) + [volume]
