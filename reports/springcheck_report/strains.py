"""Strains of cells, for the 3D views."""

import numpy as np
from springcheck_results import CELLS


def equivalent_strains(mesh, displacement):
    """Of every cell sqrt(2/3 e:e), e the deviatoric part of the logarithmic (Hencky) strain
    ln U: the change of shape alone, the strain itself where the body is pulled at constant
    volume. U: of the cell's mean deformation gradient, the one that fits its nodes' places
    best, exact where the deformation is affine. mesh, displacement (n x 3) [m] as
    springcheck_results gives them."""
    parts = [_of_cells(mesh["nodes"], mesh[name], displacement) for name in CELLS if name in mesh]
    return np.concatenate(parts)


def _of_cells(nodes, cells, displacement):
    before = nodes[cells] - nodes[cells].mean(axis=1, keepdims=True)
    after = before + displacement[cells] - displacement[cells].mean(axis=1, keepdims=True)
    gradient = np.einsum("cni,cnj->cij", after, before) @ np.linalg.inv(
        np.einsum("cni,cnj->cij", before, before)
    )
    squares = np.linalg.eigvalsh(np.einsum("cki,ckj->cij", gradient, gradient))
    # A cell without volume has stretches of 0, whose logarithm no colour can show.
    logarithms = np.log(np.maximum(squares, 1e-12)) / 2
    deviatoric = logarithms - logarithms.mean(axis=1, keepdims=True)
    return np.sqrt(2 / 3 * (deviatoric**2).sum(axis=1))
