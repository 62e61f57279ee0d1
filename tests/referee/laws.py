"""Laws as functions of the deformation gradient, of any leading shape, and figures of
them in homogeneous states."""

import numpy as np
from springs import cyclic, icosahedron, lame, sixteen_axes

IDENTITY = np.eye(3)
E = 1e4


def trace(A):
    return np.trace(A, axis1=-2, axis2=-1)


def deviator(A):
    return A - trace(A)[..., None, None] * IDENTITY / 3


def transposed(A):
    return np.swapaxes(A, -1, -2)


def kirchhoff_of_hencky(mu, F):
    """2 mu ln V, by the eigenvalues of F F^T."""
    values, axes = np.linalg.eigh(F @ transposed(F))
    return mu * (axes * np.log(values)[..., None, :]) @ transposed(axes)


def hencky(mu, K):
    """P(F) of mu |dev ln V|^2 + K/2 ln^2 J."""
    def P(F):
        pressure = (K * np.log(np.linalg.det(F)))[..., None, None]
        return (deviator(kirchhoff_of_hencky(mu, F)) + pressure * IDENTITY) @ transposed(
            np.linalg.inv(F))

    return P


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


def first_stress(pull, d, n, pressure, F):
    """P of springs of that pull over their length squared, from n at rest to d, and of a
    Kirchhoff pressure."""
    return (np.einsum("...m,...mi,mj->...ij", pull, d, n) +
            pressure * transposed(np.linalg.inv(F)))


def springs_of_hencky(mu, kappa, n, weights):
    """P(F) of lattice springs, s W' = k L^2 (u - 1)/(2 u (.7 + .3 u)), u = s^2, and of
    kappa/2 ln^2 J + mu/3 ln^3 J."""
    def P(F):
        d = np.einsum("...ij,mj->...mi", F, n)
        u = (d**2).sum(axis=-1)
        pull = mu * weights * (u - 1) / (2 * u * (0.7 + 0.3 * u)) / u
        logarithm = np.log(np.linalg.det(F))
        pressure = (kappa * logarithm + mu * logarithm**2)[..., None, None]
        return first_stress(pull, d, n, pressure, F)

    return P


def springs_in_logarithms(mu, kappa, n, weights):
    """P(F) of springs of energy k L^2 ln^2 s / 2 and of kappa/2 ln^2 J."""
    def P(F):
        d = np.einsum("...ij,mj->...mi", F, n)
        square = (d**2).sum(axis=-1)
        pull = mu * weights * np.log(square) / 2 / square
        pressure = (kappa * np.log(np.linalg.det(F)))[..., None, None]
        return first_stress(pull, d, n, pressure, F)

    return P


def isochoric_springs(mu, K, n, weights):
    """P(F) of the mean over directions of w(s), s = J^(-1/3) |F n|, s w' = 10/3 mu
    (1 - s^(-9/2)), and of K/2 ln^2 J."""
    def P(F):
        d = np.einsum("...ij,mj->...mi", F, n)
        square = (d**2).sum(axis=-1)
        J = np.linalg.det(F)[..., None]
        pull = weights * 10 / 3 * mu * (1 - (np.sqrt(square) / np.cbrt(J))**-4.5)
        pressure = (K * np.log(J) - pull.sum(axis=-1, keepdims=True) / 3)[..., None]
        return first_stress(pull / square, d, n, pressure, F)

    return P


def axes_of_a_cube():
    """25 lines through the 50 points of Lebedev's rule of degree 11."""
    lines, weights = [], []
    for kind, weight in (((1, 0, 0), 8 / 315), ((1, 1, 0), 128 / 2835),
                         ((1, 1, 1), 27 / 640), ((3, 1, 1), 14641 / 362880)):
        signs = {tuple(np.array(v) * s) for v in cyclic(kind)
                 for s in np.array(np.meshgrid(*[[1, -1]] * 3)).reshape(3, -1).T}
        first = {max(v, tuple(-np.array(v))) for v in signs}
        lines += sorted(first)
        weights += [weight] * len(first)
    n = np.array(lines, dtype=float)
    return n / np.linalg.norm(n, axis=1)[:, None], np.array(weights)


def all_directions(count=12):
    """Gauss's points along an axis times equal angles around it, and their weights in the
    mean over half a sphere: exact to the degree 2 count - 1."""
    z, weights = np.polynomial.legendre.leggauss(count)
    angles = (np.arange(2 * count) + 0.5) * np.pi / (2 * count)
    r = np.sqrt(1 - z**2)[:, None]
    n = np.stack(np.broadcast_arrays(r * np.cos(angles), r * np.sin(angles), z[:, None]),
                 axis=-1)
    return n.reshape(-1, 3), np.repeat(weights, 2 * count) / (4 * count)


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


# --------------------------------------------------------------------------- figures


def bars():
    """Of mss-cf's continuum along lines of the lattice: stress over E strain."""
    n, weights = lattice_directions(A=1)
    for nu in (0.25, 0.499):
        law = cauchy_born(E, nu, n, weights)
        for line in ("100", "110", "111"):
            for strain in (-0.05, -0.2):
                stress = bar_stress(law, [int(c) for c in line], 1 + strain)
                yield f"mss-cf nu {nu:g} along {line} {strain:g}", "stress", float(
                    stress / (E * strain))


def rotation(angle, axis):
    x, y, z = axis / np.linalg.norm(axis)
    W = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * W + (1 - np.cos(angle)) * W @ W


def turns():
    """How far the stress of virtual springs of engineering strain in simple shear depends
    on how the body lies: over 300 turns the largest spread of a component over the
    largest; and the norm of what a quarter of a turn about z changes, over the norm."""
    _, mu = lame(E, 0.25)
    six = icosahedron(), np.full(6, 1 / 6)

    def stress(axes, shear, Q):
        """Of the body that lies turned, as the body sees it."""
        F = np.eye(3)
        F[0, 2] = shear
        n, w = axes
        return Q.T @ pull_of_springs(n, 15 * w, mu, Q @ F @ Q.T) @ Q

    for name, shear, axes in ((6, 0.05, six), (6, 0.2, six), (16, 0.2, sixteen_axes()),
                              (16, 0.5, sixteen_axes())):
        stresses = np.array([
            stress(axes, shear, rotation(0.7 * i, np.array([np.sin(i), np.sin(2 * i + 1),
                                                            np.cos(3 * i)])).T)
            for i in range(300)])
        spread = np.ptp(stresses, axis=0).max() / np.abs(stresses).max()
        yield f"{name} axes sheared by {shear:g}", "spread", float(spread)
    quarter = rotation(np.pi / 2, np.array([0, 0, 1]))
    straight, turned = stress(six, 0.2, np.eye(3)), stress(six, 0.2, quarter)
    yield "6 axes sheared by 0.2", "change by a quarter of a turn", float(
        np.linalg.norm(turned - straight) / np.linalg.norm(straight))


def off_hencky():
    """Stress of springs less Hencky's over Hencky's, root of the mean square over 20,000
    states of random principal stretches, turned at random before and after; near nu = 1/2
    the volume is kept to .2 %. Seed 1."""
    def random_turns(random, count):
        q = random.normal(size=(count, 4))
        w, x, y, z = (q / np.linalg.norm(q, axis=1)[:, None]).T
        return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                         [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                         [2 * (x * z - y * w), 2 * (y * z + x * w),
                          1 - 2 * (x * x + y * y)]]).transpose(2, 0, 1)

    def error(law, nu, size, count=20000):
        random = np.random.default_rng(1)
        s = 1 + size * random.uniform(-1, 1, (count, 3))
        if nu > 0.45:
            volume = 1 + 0.002 * random.uniform(-1, 1, count)
            s *= (volume / np.cbrt(s.prod(axis=1)))[:, None]
        F = random_turns(random, count) * s[:, None, :] @ random_turns(random, count)
        la, mu = lame(E, nu)
        exact = hencky(mu, la + 2 * mu / 3)(F)
        return float(np.linalg.norm(law(F) - exact) / np.linalg.norm(exact))

    six = icosahedron(), np.full(6, 1 / 6)
    for nu in (0, 0.25, 0.4, 0.499):
        la, mu = lame(E, nu)
        kappa, K = la - mu, la + 2 * mu / 3
        for name, law, size in (
            ("lattice engineering", cauchy_born(E, nu, *lattice_directions(1)), 0.2),
            ("lattice logarithmic", springs_in_logarithms(mu, kappa, *lattice_directions(1)),
             0.2),
            ("lattice hencky A 1", springs_of_hencky(mu, kappa, *lattice_directions(1)), 0.2),
            ("lattice hencky A 16/9", springs_of_hencky(mu, kappa, *lattice_directions(16 / 9)),
             0.2),
            ("6 axes", isochoric_springs(mu, K, *six), 0.2),
            ("16 axes", isochoric_springs(mu, K, *sixteen_axes()), 0.1),
            ("16 axes", isochoric_springs(mu, K, *sixteen_axes()), 0.2),
            ("25 axes", isochoric_springs(mu, K, *axes_of_a_cube()), 0.2),
            ("all directions", isochoric_springs(mu, K, *all_directions()), 0.2)):
            yield f"{name} nu {nu:g} stretches {size:g}", "off", error(law, nu, size)
