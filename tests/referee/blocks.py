"""Blocks of equal cells between two plates, and equilibria on them.

Lengths in m, forces in N. Nodes are numbered along x first, then y, then z; those of a
cell in the same order, (degree + 1)^3 of them: corners, and of degree 2 those between.
A body is a list of parts, each with

    gradient(x), hessian(x)      x of shape (nodes, 3)

of its energy, of which the last is a sparse matrix of all components.
"""

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg


def lattice_points(*counts):
    """(i, j, k) of a lattice of so many points along each axis, the first fastest."""
    k, j, i = np.meshgrid(*(np.arange(n) for n in reversed(counts)), indexing="ij")
    return np.stack([i.ravel(), j.ravel(), k.ravel()], axis=1)


CORNERS = lattice_points(2, 2, 2)


@dataclass
class Block:
    """`cells` of three counts, `size` of three edges; displacements are polynomials of
    the `degree` along each axis of a cell."""

    size: tuple
    cells: tuple
    degree: int = 1

    def __post_init__(self):
        self.edges = np.array(self.size) / self.cells
        counts = self.degree * np.array(self.cells) + 1
        steps = lattice_points(*counts)
        self.nodes = steps * self.edges / self.degree
        self.layer = steps[:, 2]
        number = [1, counts[0], counts[0] * counts[1]]
        first = self.degree * lattice_points(*self.cells) @ number
        self.cell_nodes = first[:, None] + lattice_points(*[self.degree + 1] * 3) @ number
        self.cell_volume = float(np.prod(self.edges))
        self.volume = float(np.prod(self.size))

    @property
    def top(self):
        return self.layer == self.layer[-1]

    @property
    def bottom(self):
        return self.layer == 0

    def middle_of_top(self):
        """The node at the centre of the upper face, of even counts and degree 1."""
        layer = (self.cells[0] + 1) * (self.cells[1] + 1)
        return len(self.nodes) - 1 - layer // 2

    def masses(self, density):
        """An eighth of each cell to each of its corners, of degree 1 [kg]."""
        return density * self.cell_volume / 8 * np.bincount(self.cell_nodes.ravel())

    def assembled(self, gradients):
        """Of gradients of cells, (cells, nodes of each, 3), those of nodes."""
        total = np.zeros_like(self.nodes)
        np.add.at(total, self.cell_nodes, gradients)
        return total

    def components(self):
        return (3 * self.cell_nodes[:, :, None] + np.arange(3)).reshape(len(self.cell_nodes), -1)

    def assembled_matrix(self, hessians):
        """Of matrices of cells, as large as they have components, the one of all."""
        own = self.components()
        rows = np.repeat(own, own.shape[1], axis=1).ravel()
        columns = np.tile(own, (1, own.shape[1])).ravel()
        n = 3 * len(self.nodes)
        return sparse.csc_matrix((hessians.ravel(), (rows, columns)), shape=(n, n))

    def exact_volume(self, x):
        """det of the Jacobian at Gauss points: exact, its degree in each direction being
        three times that of displacements, less one."""
        B, weights = gauss_gradients(self.edges, self.degree)
        jacobians = np.einsum("cad,qae->cqde", x[self.cell_nodes], B)
        return float((np.linalg.det(jacobians) @ weights).sum() * self.cell_volume)

    def corner_jacobians(self, x):
        """det F at the corners of all cells."""
        gradients = np.stack([shape_gradients(c, self.edges, self.degree) for c in CORNERS])
        return np.linalg.det(np.einsum("cad,qae->cqde", x[self.cell_nodes], gradients))


def lagrange(degree):
    """Polynomials that are one at one of degree + 1 equidistant points of [0, 1] and zero
    at the others."""
    places = np.linspace(0, 1, degree + 1)
    return [np.poly1d(others, r=True) / np.prod(place - others)
            for place, others in ((p, np.delete(places, i)) for i, p in enumerate(places))]


def shape_gradients(point, edges, degree=1):
    """Of a cell's (degree + 1)^3 products of Lagrange's polynomials at a point of the
    unit cell, (functions, 3) [1/m]."""
    functions = lagrange(degree)
    values = np.array([[f(s) for s in point] for f in functions])
    slopes = np.array([[f.deriv()(s) for s in point] for f in functions]) / edges
    factors = np.stack([np.where(np.eye(3, dtype=bool)[d], slopes, values) for d in range(3)])
    i, j, k = lattice_points(*[degree + 1] * 3).T
    return (factors[:, i, 0] * factors[:, j, 1] * factors[:, k, 2]).T


def gauss_gradients(edges, degree=1):
    """At degree + 1 Gauss points along each axis, (points, functions, 3); and each point's
    part of the volume."""
    places, weights = np.polynomial.legendre.leggauss(degree + 1)
    points = lattice_points(*[degree + 1] * 3)
    gradients = [shape_gradients(p, edges, degree) for p in (1 + places[points]) / 2]
    return np.stack(gradients), (weights[points] / 2).prod(axis=1)


# ------------------------------------------------------------------------- motions


def shifted(vector):
    return lambda block, fraction: block.nodes + fraction * np.asarray(vector)


def turned(angle):
    """Right-handed about the axis of the block [rad]."""

    def motion(block, fraction):
        x = block.nodes.copy()
        middle = np.array([block.size[0] / 2, block.size[1] / 2, 0])
        c, s = np.cos(fraction * angle), np.sin(fraction * angle)
        turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        return (x - middle) @ turn.T + middle

    return motion


# --------------------------------------------------------------------- equilibrium


class NotConverged(Exception):
    pass


def total_gradient(parts, x):
    return sum(part.gradient(x) for part in parts)


def total_hessian(parts, x):
    return sum(part.hessian(x) for part in parts)


def free_components(fixed_nodes):
    return np.flatnonzero(~np.repeat(fixed_nodes, 3))


@np.errstate(all="ignore")  # states far off overflow, and that is told below
def newton(parts, x, free, force, factors, most=60):
    """The state near x where the gradient is `force` in the free components, to 1e-11 of
    the largest reaction, or, where rounding leaves more, to what it leaves, 1e-8 at
    most. The tangent, at first that of `factors`, is kept as long as residuals fall to a
    tenth."""
    before = np.inf
    for _ in range(most):
        g = total_gradient(parts, x) - force
        residual = np.abs(g.ravel()[free]).max()
        if not np.isfinite(residual):
            raise NotConverged("not finite")
        off = residual / max(np.abs(g).max(), np.abs(force).max(), 1e-300)
        if off <= 1e-11 or (off <= 1e-8 and residual > before / 2):
            return x
        if residual > before / 10:
            factors = factorised(total_hessian(parts, x)[free][:, free].tocsc())
        before = residual
        moved = x.ravel().copy()
        moved[free] -= factors.solve(g.ravel()[free])
        x = moved.reshape(-1, 3)
    raise NotConverged(f"residual {residual:g} after {most} steps")


def factorised(matrix):
    """L D L^T by SuperLU without pivoting, whose D has the matrix's inertia."""
    try:
        return linalg.splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0,
                           options={"SymmetricMode": True})
    except RuntimeError as error:
        raise NotConverged(f"SuperLU: {error}") from error


def negative_eigenvalues(matrix):
    lu = factorised(matrix)
    assert np.array_equal(lu.perm_r, lu.perm_c), "a pivot was taken off the diagonal"
    return int((lu.U.diagonal() < 0).sum())


@dataclass
class State:
    x: np.ndarray
    reactions: np.ndarray  # the gradient less the load [N]


class Path:
    """The equilibria of a body whose lower plate stays and whose upper one follows
    `motion`, or is free where there is none, under `force` on nodes."""

    def __init__(self, block, parts, motion=None, force=None):
        self.block, self.parts, self.motion = block, parts, motion
        self.force = np.zeros_like(block.nodes) if force is None else force
        self.held = block.bottom | (block.top if motion else False)
        self.free = free_components(self.held)
        self.x, self.fraction = block.nodes.copy(), 0.0

    def advance(self, fraction):
        """One step of the load: the tangent's guess, then Newton's method."""
        before, x = self.x, self.x.copy()
        if self.motion:
            x[self.block.top] = self.motion(self.block, fraction)[self.block.top]
        prescribed = (x - before).ravel()
        hessian = total_hessian(self.parts, before)
        rest = hessian @ prescribed + (total_gradient(self.parts, before) -
                                       fraction * self.force).ravel()
        factors = factorised(hessian[self.free][:, self.free].tocsc())
        moved = x.ravel()
        moved[self.free] -= factors.solve(rest[self.free])
        self.x = newton(self.parts, moved.reshape(-1, 3), self.free, fraction * self.force,
                        factors)
        self.fraction = fraction
        return self

    def state(self):
        return State(self.x, total_gradient(self.parts, self.x) - self.fraction * self.force)

    def is_stable(self):
        matrix = total_hessian(self.parts, self.x)[self.free][:, self.free].tocsc()
        return negative_eigenvalues(matrix) == 0

    def is_right_side_out(self):
        return self.block.corner_jacobians(self.x).min() > 0


def equilibrium(block, parts, motion=None, force=None, steps=1):
    """Stable, or AssertionError; with more steps where those given are too few."""
    path = Path(block, parts, motion, force)
    try:
        for step in range(1, steps + 1):
            path.advance(step / steps)
    except NotConverged:
        if steps > 100:
            raise
        return equilibrium(block, parts, motion, force, 2 * steps)
    assert path.is_stable(), "a saddle"
    return path.state()


def limit_of_stability(path, step, resolution):
    """(fraction, how) to which the path is stable, right side out and found, by steps
    and bisection: how it ends is a 'bifurcation', an 'inversion', 'no equilibrium' or
    'none'. The fraction is the last at which all is well."""
    while path.fraction < 1:
        before = path.x, path.fraction
        try:
            path.advance(min(path.fraction + step, 1.0))
            how = (None if path.is_stable() and path.is_right_side_out() else
                   "bifurcation" if path.is_right_side_out() else "inversion")
        except NotConverged:
            how = "no equilibrium"
        if how is None:
            continue
        path.x, path.fraction = before
        if step <= resolution:
            return path.fraction, how
        step /= 2
    return 1.0, "none"


# ------------------------------------------------------------------------ measures


def plate_force(block, state):
    return state.reactions[block.top].sum(axis=0)


def plate_torque(block, state, small_strain=False):
    """About the axis, arms in the deformed state, or of small strain at rest [N m]."""
    places = block.nodes if small_strain else state.x
    arms = places[block.top] - [block.size[0] / 2, block.size[1] / 2, 0]
    forces = state.reactions[block.top]
    return float((arms[:, 0] * forces[:, 1] - arms[:, 1] * forces[:, 0]).sum())


def volume_change(block, state):
    return block.exact_volume(state.x) / block.volume - 1
