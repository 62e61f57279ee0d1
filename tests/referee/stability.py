"""Figures of stability: where paths and lattices lose it, and how long a step may be."""

import numpy as np
import scipy.optimize as optimize
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg
from blocks import CORNERS, Block, Path, limit_of_stability, shifted, total_hessian, turned
from elements import st_venant_kirchhoff_parted
from springs import dashpots, lattice, whole_springs

E, h = 1e4, 0.005


def cube(n):
    return Block((n * h,) * 3, (n, n, n))


def paths():
    """The strain or angle up to which a state is a minimum."""
    ten, six, beam = cube(10), cube(6), Block((4 * h, 4 * h, 24 * h), (4, 4, 24))

    def limit(block, method, nu, motion, full, step):
        parts = (st_venant_kirchhoff_parted(block, E, nu) if method == "fem-stvk" else
                 lattice(block, method, E, nu))
        path = Path(block, parts, motion)
        fraction, how = limit_of_stability(path, step / full, 1e-4 * step / full)
        return full * fraction, how

    for method, nu, step in (("mss-nfd", 0, 0.005), ("mss-nfd", 0.25, 0.005),
                             ("mss-nfd", 0.499, 0.005), ("mss-baudet", 0, 0.01),
                             ("mss-cf", 0, 0.05), ("mss-cf", 0.25, 0.05),
                             ("mss-cf", 0.499, 0.05)):
        found, how = limit(ten, method, nu, shifted((0, 0, -0.5 * 10 * h)), 0.5, step)
        yield f"compression {method} nu {nu:g} {how}", "strain", found
    for cells in (6, 10):
        found, how = limit(cube(cells), "fem-stvk", 0.25,
                           shifted((0, 0, -0.5 * cells * h)), 0.5, 0.05)
        yield f"compression fem-stvk {cells} across nu 0.25 {how}", "strain", found
    for nu in (0, 0.1):
        found, how = limit(beam, "mss-cf", nu, shifted((0, 0, 0.5 * 24 * h)), 0.5, 0.025)
        yield f"tension mss-cf nu {nu:g} {how}", "strain", found
    for nu in (0, 0.1, 0.25, 0.4):
        found, how = limit(six, "mss-cf", nu, turned(np.pi), 180, 5)
        yield f"torsion mss-cf nu {nu:g} {how}", "degrees", found


def waves():
    """The strain in compression at which the infinite lattice, its sides free, loses its
    first wave; long ones included."""
    cell = Block((h, h, h), (1, 1, 1))
    short = [np.array([a, b, c]) * np.pi / 8 for a in range(9) for b in range(9)
             for c in range(9) if a + b + c > 0]
    long = [1e-3 * t for t in {tuple(np.round(t / np.linalg.norm(t), 12)): t /
                               np.linalg.norm(t) for t in short}.values()]

    def lowest(parts, z):
        def energy_slope(l):
            x = cell.nodes * [l, l, z]
            return float((sum(p.gradient(x) for p in parts) * cell.nodes * [1, 1, 0]).sum())

        l = optimize.brentq(energy_slope, 0.9, 0.1 + 1 / np.sqrt(z), xtol=1e-13)
        H = total_hessian(parts, cell.nodes * [l, l, z]).toarray().reshape(8, 3, 8, 3)

        def modulus(t):
            """The least eigenvalue over that of the lattice's Laplacian, so that long
            waves, whose eigenvalues go with t^2, can be held against others."""
            phase = np.expm1(1j * CORNERS @ t)  # less one: a cell that moves has no forces
            D = np.einsum("a,akbl,b->kl", phase.conj(), H, phase)
            return np.linalg.eigvalsh(D)[0] / (np.sin(t / 2)**2).sum()

        # The least point of a grid is not always beside the least of all.
        starts = sorted(short, key=modulus)[:8] + sorted(long, key=modulus)[:4]
        corners = np.vstack([np.zeros(3), np.eye(3)])
        return min(optimize.minimize(
            modulus, start, method="Nelder-Mead",
            options={"xatol": 1e-7, "fatol": 1e-12 * abs(modulus(start)),
                     "initial_simplex": start + 0.05 * np.linalg.norm(start) * corners}).fun
                   for start in starts)

    for A in (0.01, 0.1, 1, 10):
        for nu in (0, 0.25, 0.499):
            parts = lattice(cell, "mss-cf", E, nu, A=A)
            stable, lost = 0.0, 0.0
            while lowest(parts, 1 - lost - 0.02) > 0:
                lost += 0.02
            stable, lost = lost, lost + 0.02
            while lost - stable > 1e-6:
                middle = (stable + lost) / 2
                if lowest(parts, 1 - middle) > 0:
                    stable = middle
                else:
                    lost = middle
            yield f"A {A:g} nu {nu:g}", "strain", lost


def steps():
    """The largest stable step of symplectic Euler, a free block of 10^3 cells [s]; with
    dashpots that at which an amplitude turns round from step to step:
    2 M v = (dt C + dt^2/2 K) v."""
    block = cube(10)
    masses = block.masses(1000)
    scale = sparse.diags(1 / np.sqrt(np.repeat(masses, 3)))

    def largest(matrix):
        return linalg.eigsh(scale @ matrix @ scale, k=1, which="LA", tol=1e-12,
                            return_eigenvectors=False)[0]

    poisson = {"mss-cf": (0, 0.1, 0.25, 0.3, 0.4, 0.45, 0.49, 0.499),
               "mss-nfd": (0, 0.1, 0.25, 0.3, 0.4, 0.45, 0.49, 0.499),
               "mss-baudet": (0, 0.25, 0.499)}
    for method, ratios in poisson.items():
        for nu in ratios:
            K = total_hessian(lattice(block, method, E, nu), block.nodes)
            yield f"{method} nu {nu:g} zeta 0", "step", float(2 / np.sqrt(largest(K)))

    K = total_hessian(lattice(block, "mss-cf", E, 0.25), block.nodes)
    for zeta in (0.05, 0.2, 0.5, 1):
        C = dashpots(block, "mss-cf", E, 0.25, masses, zeta)
        dt = optimize.brentq(lambda dt: largest(dt * C + dt**2 / 2 * K) - 2, 1e-5, 2e-3,
                             xtol=1e-10)
        yield f"mss-cf nu 0.25 zeta {zeta:g}", "step", float(dt)


def motion():
    """The thesis's protocol as it ran: 5 m for 5 cm, 10 s, steps of 1 ms, no dashpots;
    the upper plate at constant velocity, forces of the last state on it over E L^2."""
    block = Block((5, 5, 5), (10, 10, 10))
    ends, k, L = whole_springs(block, "mss-cf", E, 0.25)  # kappa = 0 at nu = 1/4

    def forces(x):
        d = x[ends[:, 1]] - x[ends[:, 0]]
        s = np.linalg.norm(d, axis=1)
        pull = (k * (s - L) / s)[:, None] * d
        return np.stack([np.bincount(ends[:, 0], pull[:, i], len(x)) -
                         np.bincount(ends[:, 1], pull[:, i], len(x)) for i in range(3)], axis=1)

    free = ~(block.top | block.bottom)
    masses = block.masses(1000)[free, None]
    dt, count, way = 1e-3, 10000, 0.05 * 5
    x, v = block.nodes.copy(), np.zeros((free.sum(), 3))
    for step in range(1, count + 1):
        v += dt * forces(x)[free] / masses
        x[free] += dt * v
        x[block.top, 0] = block.nodes[block.top, 0] + way * step / count
    yield "shearing 0.05 mss-cf", "norm of force", float(
        np.linalg.norm(forces(x)[block.top].sum(axis=0)))
