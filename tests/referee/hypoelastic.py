"""The law of many programs that are called linear elastic at large strain: a rate of stress
in proportion to the rate of deformation, Jaumann's rate, whose result depends on the steps.

Integrated at the midpoint (Hughes and Winget, Int. J. Numer. Methods Eng. 15 (1980) 1862):

    G = d(x - x0)/dx_m,  x_m = (x + x0)/2,  R = (I - W/2)^-1 (I + W/2),
    sigma = R sigma0 R^T + 2 mu dev D + K tr D I,   D = sym G, W = skw G

on trilinear hexahedra, with the cell's mean of tr D.
"""

from dataclasses import dataclass, field

import numpy as np
from blocks import Block, Path, plate_torque, volume_change
from elements import quadrature, slopes_by_nodes
from laws import IDENTITY, deviator, trace, transposed
from springs import lame
from statics import CUBE, E, pressed, twisted


@dataclass
class Step:
    """A body of which gradient(x) is that at the end of a step from x0 and its stress."""

    block: Block
    nu: float
    before: np.ndarray = None
    stress: np.ndarray = None  # (cells, 8, 3, 3), of the step's beginning
    found: np.ndarray = field(default=None, repr=False)

    def __post_init__(self):
        self.before = self.block.nodes[self.block.cell_nodes]
        self.stress = np.zeros((len(self.before), 8, 3, 3))

    def gradient(self, x):
        return self.block.assembled(self.cell_gradient(x[self.block.cell_nodes]))

    def hessian(self, x):
        return self.block.assembled_matrix(slopes_by_nodes(self.cell_gradient, self.block, x))

    def cell_gradient(self, X):
        la, mu = lame(E, self.nu)
        B, VB = quadrature(self.block)
        middle = np.einsum("cad,qae->cqde", (X + self.before) / 2, B)
        G = np.einsum("cad,qae->cqde", X - self.before, B) @ np.linalg.inv(middle)
        D, W = (G + transposed(G)) / 2, (G - transposed(G)) / 2
        R = np.linalg.solve(IDENTITY - W / 2, IDENTITY + W / 2)
        mean = trace(D).mean(axis=1)[:, None, None, None]
        self.found = (R @ self.stress @ transposed(R) + 2 * mu * deviator(D) +
                      (la + 2 * mu / 3) * mean * IDENTITY)
        F = np.einsum("cad,qae->cqde", X, B)
        P = np.linalg.det(F)[..., None, None] * self.found @ transposed(np.linalg.inv(F))
        return np.einsum("cqde,qae->cad", P, VB)


def end_of(load, nu, count):
    step = Step(CUBE, nu)
    path = Path(CUBE, [step], load[2](CUBE))
    for i in range(1, count + 1):
        path.advance(i / count)
        X = path.x[CUBE.cell_nodes]
        step.cell_gradient(X)
        step.before, step.stress = X, step.found
        # The gradient at the end, of no further step, is the same.
    return path.state()


def steps():
    for strain in (0.05, 0.2):
        state = end_of(pressed(strain), 0.25, 10)
        yield (f"compression {strain:g} nu 0.25 in 10 steps", "volume change",
               volume_change(CUBE, state))
    for count in (2, 4, 30):
        yield (f"torsion 45 nu 0.25 in {count} steps", "torque",
               plate_torque(CUBE, end_of(twisted(45), 0.25, count)))
