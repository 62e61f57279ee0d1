"""Figures of theories: the elastica, volumes, and living tissue in simple shear, by
quadrature and by integration in time."""

import numpy as np
import scipy.integrate as integrate
import scipy.optimize as optimize
from blocks import CORNERS, gauss_gradients
from laws import lattice_directions
from scipy.special import gamma as gamma_function
from springs import constants

# K [Pa s^n], n, gamma_lim, p: Golec 2018, Table 4.1; the limit of its springs: Table 4.2
ORGANS = {"spleen": (758, 0.1043, 0.73, 1.6, 400.0),
          "liver": (861, 0.1138, 0.40, 4.17, 0.45),
          "kidney": (1818, 0.0892, 0.11, 2.64, 0.07)}
RATES = 0.0151, 0.133, 0.67


def elastica():
    """The drop of the tip of an inextensible cantilever of 0.4 x 0.4 x 2.4 m under its
    weight: E I theta'' = -w (L - s) cos theta, theta(0) = 0, theta'(L) = 0."""
    L, w = 2.4, 1000 * 10 * 0.4 * 0.4

    def shot(start, EI):
        return integrate.solve_ivp(
            lambda s, y: [y[1], -w * (L - s) * np.cos(y[0]) / EI, np.sin(y[0])], (0, L),
            [0, start, 0], rtol=1e-11, atol=1e-13).y[:, -1]

    for E in (10e6, 2e6):
        EI = E * 0.4**4 / 12
        start = optimize.brentq(lambda k: shot(k, EI)[1], 0, w * L**2 / (2 * EI), xtol=1e-14)
        yield f"E {E:g}", "drop of the tip", float(shot(start, EI)[2])


def volumes():
    """By how much six tetrahedra around a diagonal miss the volume of a hexahedron whose
    corners are off by up to 20 % of the edge, over 200,000 of them, seed 1; and what the
    kidney's hilum leaves of the ellipsoid between its planes, |z| < .8."""
    X = CORNERS + np.random.default_rng(1).uniform(-0.2, 0.2, (200000, 8, 3))
    exact = np.linalg.det(np.einsum("cad,qae->cqde", X, gauss_gradients(np.ones(3))[0]))
    exact = exact.mean(axis=1)
    six = 0.0
    for first, second in ((1, 3), (3, 2), (2, 6), (6, 4), (4, 5), (5, 1)):
        sides = np.stack([X[:, i] - X[:, 0] for i in (first, second, 7)], axis=1)
        six = six + np.linalg.det(sides) / 6
    off = six / exact - 1
    yield "six tetrahedra", "root mean square", float(np.sqrt((off**2).mean()))
    yield "six tetrahedra", "mean of the absolute value", float(np.abs(off).mean())

    def chord(x, z):  # of both ellipsoids in y
        hilum, body = 1 - z * z - ((x - 1.1) / 0.5)**2, 1 - x * x - z * z
        return 2 * min(0.4 * np.sqrt(max(hilum, 0)), np.sqrt(max(body, 0)))

    taken = integrate.dblquad(chord, 0, 0.8, 0.6, 1.0, epsabs=1e-7)[0] * 2
    yield "kidney", "left by the hilum", float(1 - taken / (np.pi * (1.6 - 2 * 0.8**3 / 3)))


# ------------------------------------------------------------------ the law of tissue


def past(law, begin, end, strain, rate):
    """Parts of int G(t', gamma - rate (..)) rate dt' over t' from begin to end after the
    change of strain, G = K/Gamma(1-n) t'^-n {1 + (gamma'/gamma_lim)^p}, gamma' what of
    the strain came since: strain less rate times what had passed. The singularity is
    taken away by u = t'^(1-n)."""
    K, n, limit, p = law[:4]
    span = begin**(1 - n), end**(1 - n)

    def since(u):  # the strain since a time t' before now
        return max(strain - rate * (end - u**(1 / (1 - n))), 0.0)

    scale = K * rate / ((1 - n) * gamma_function(1 - n))
    rule = {"epsabs": 0, "epsrel": 1e-12, "limit": 400}
    return (scale * integrate.quad(lambda u: 1.0, *span, **rule)[0],
            scale * integrate.quad(lambda u: (since(u) / limit)**p, *span, **rule)[0])


def constant_rate(law, strain, rate):
    """Linear and hardening part of the stress [Pa]."""
    return past(law, 0.0, strain / rate, strain, rate)


def tissue_at_rate():
    for organ, law in ORGANS.items():
        for rate in RATES:
            for strain in (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0):
                yield (organ, rate, strain, *constant_rate(law, strain, rate))


def tissue_held():
    """After a ramp; the rate of 'inf' is a step, whose strain is all of one time."""
    for organ, law in ORGANS.items():
        K, n, limit, p = law[:4]
        for strain in (0.01, 0.1, 0.5, 1.0):
            for held in (0.001, 0.01, 0.1, 1, 10, 70, 100, 1000):
                for rate in RATES:
                    parts = past(law, held, held + strain / rate, strain, rate)
                    yield organ, strain, rate, held, sum(parts)
                mean = 1 + integrate.quad(lambda s: (s * strain / limit)**p, 0, 1,
                                          epsabs=0, epsrel=1e-12)[0]
                G = K / gamma_function(1 - n) * held**-n
                yield organ, strain, "inf", held, G * strain * mean


def tissue_oscillating():
    """G' and G'' of G0(t) = K t^-n/Gamma(1-n): omega times the integrals of G0 with sine
    and cosine, over a period with the singular weight, and on by QUADPACK's rule for
    oscillating integrands."""
    for organ, (K, n, *_) in ORGANS.items():
        for omega in (0.01, 0.1, 1, 10, 100):
            period = 2 * np.pi / omega
            moduli = []
            for name, function in (("sin", np.sin), ("cos", np.cos)):
                near = integrate.quad(lambda t: function(omega * t), 0, period, weight="alg",
                                      wvar=(-n, 0), epsabs=0, epsrel=1e-12)[0]
                far = integrate.quad(lambda t: t**-n, period, np.inf, weight=name, wvar=omega,
                                     epsabs=1e-11 * period, limlst=200)[0]
                moduli.append(float(omega * K / gamma_function(1 - n) * (near + far)))
            yield organ, omega, *moduli


def tissue_between_discs():
    """Torque of a disc whose rim has the strain and the rate [N m]."""
    for organ, law in ORGANS.items():
        for radius in (0.0075, 0.01):
            for rate in RATES:
                for strain in (0.001, 0.02, 0.1, 0.3, 1.0):
                    def ring(r):
                        share = r / radius
                        return sum(constant_rate(law, strain * share, rate * share)) * r**2
                    torque = 2 * np.pi * integrate.quad(ring, 0, radius, epsabs=0,
                                                        epsrel=1e-10)[0]
                    yield organ, radius, rate, strain, float(torque)


# ----------------------------------------------------------------- what replaces it

# Any branches do to try a formula on: relaxation times, G, B; the last two an elastic
# branch's G and B and a dashpot's viscosity.
BRANCHES = (0.1, 200.0, 150.0), (3.0, 100.0, 0.0), (40.0, 70.0, 90.0)
ELASTIC, VISCOSITY, LIMIT, INDEX = (400.0, 300.0), 0.5, 0.4, 3.0


def branches_at_rate():
    """Stress of branches whose tensors follow dA/dt = (C^-1 - A)/tau in simple shear, by
    integration in time: sum M A_xz + eta rate, M = G + B (I/gamma_lim^2)^(p/2)/(p+1),
    I = tr(C A) - 3."""
    def C_of(strain):
        F = np.eye(3)
        F[0, 2] = strain
        return F.T @ F

    for rate in (0.02, 0.5, 20):
        for strain in (0.01, 0.3, 1.0):
            stress = VISCOSITY * rate
            for tau, G, B in ((None, *ELASTIC), *BRANCHES):
                A = np.eye(3)
                if tau is not None:
                    A = integrate.solve_ivp(
                        lambda t, a: ((np.linalg.inv(C_of(rate * t)) - a.reshape(3, 3)) /
                                      tau).ravel(), (0, strain / rate), np.eye(3).ravel(),
                        rtol=1e-11, atol=1e-13, method="DOP853").y[:, -1].reshape(3, 3)
                F = np.eye(3)
                F[0, 2] = strain
                mean_square = np.trace(C_of(strain) @ A) - 3
                M = G + B * (mean_square / LIMIT**2)**(INDEX / 2) / (INDEX + 1)
                stress += M * (F @ A @ F.T)[0, 2]
            yield rate, strain, float(stress)


def thesis_springs():
    """The lattice of the thesis's springs (Eq. 4.4) in simple shear, without dashpots:
    its stress over the law's at the same rate, root mean square of the logarithm over
    strains of 0.01 to 1; and its stress [Pa]."""
    h = 0.005
    directions, _ = lattice_directions(1)
    lengths = h * np.array([1.0] * 3 + [np.sqrt(2)] * 6 + [np.sqrt(3)] * 4)
    for organ, law in ORGANS.items():
        K, n, _, p, limit = law
        k = np.repeat(constants(h, K, 0.499, 1), (3, 6, 4))

        def stress(strain):
            F = np.eye(3)
            F[0, 2] = strain
            d = lengths[:, None] * directions @ F.T
            length = np.linalg.norm(d, axis=1)
            longer = length - lengths
            pull = k * np.abs(longer)**(1 - n) * np.sign(longer) * (
                1 + (np.abs(longer) / (limit * lengths))**(p - (1 - n)))
            return float((pull * d[:, 0] * d[:, 2] / length).sum() / h**3)

        for strain in (0.01, 0.1, 1.0):
            yield f"{organ} sheared by {strain:g}", "stress", stress(strain)
        strains = np.geomspace(0.01, 1, 61)
        for rate in RATES:
            off = [np.log(stress(s) / sum(constant_rate(law, s, rate))) for s in strains]
            yield (f"{organ} at {rate:g}", "root mean square of ln",
                   float(np.sqrt(np.mean(np.square(off)))))
