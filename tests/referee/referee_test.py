"""Checks of the referee itself: forces against energies, tangents against forces, and what
is said of the hypoelastic law in docs/explanation/thesis.md and in the thesis's gates."""

import csv
import unittest

import elements
import numpy as np
from blocks import Block
from energies import Stars, Volumes
from figures import FOLDER
from springs import affine, lattice

BLOCK = Block((0.03, 0.02, 0.02), (3, 2, 2))


def bodies():
    for nu in (0.1, 0.45):
        for method in ("mss-cf", "mss-nfd", "mss-baudet", "mss-fd"):
            yield f"{method} nu {nu}", lattice(BLOCK, method, 1e4, nu)
        for measure in ("green", "logarithmic", "hencky"):
            yield f"{measure} nu {nu}", lattice(BLOCK, "mss-cf", 1e4, nu, measure=measure)
        for stars in (False, True):
            yield f"mss-affine nu {nu} {stars}", affine(BLOCK, 1e4, nu, stars)


def averaged():
    """Elements whose volumetric part is a mean, over cells or around nodes."""
    for means in (Volumes, Stars):
        for parted in (elements.hooke_parted, elements.st_venant_kirchhoff_parted,
                       elements.hencky_parted, elements.continuum_of_lattice_parted):
            yield f"{parted.__name__} {means.__name__}", parted(BLOCK, 1e4, 0.3, means)


def state(seed, block=BLOCK):
    random = np.random.default_rng(seed)
    x = block.nodes @ (np.eye(3) + 0.2 * random.uniform(-1, 1, (3, 3)))
    return x + 0.0005 * random.uniform(-1, 1, x.shape), random.uniform(-1, 1, x.shape)


def slope(function, x, way, step=1e-7):
    return (function(x + step * way) - function(x - step * way)) / (2 * step)


def figures(topic, key):
    with open(FOLDER / f"{topic}.csv", newline="") as file:
        return {key(row): float(row["value"]) for row in csv.DictReader(file)}


class Derivatives(unittest.TestCase):
    # Differences of a step of 1e-5 of a cell leave 1e-10 of the slope and rounding.

    def test_forces_are_slopes_of_energies(self):
        volumetric = [(name, parts[1:]) for name, parts in averaged()]
        for name, parts in [*bodies(), *volumetric]:
            for seed, part in enumerate(parts):
                x, way = state(seed)
                if np.isnan(part.energy(x)):
                    continue  # hencky's springs, whose energy is not written out
                with self.subTest(name, part=type(part).__name__):
                    found = (part.gradient(x) * way).sum()
                    self.assertAlmostEqual(slope(part.energy, x, way) / found, 1, delta=1e-6)

    def test_tangents_are_slopes_of_forces(self):
        quadratic = Block(BLOCK.size, BLOCK.cells, degree=2)
        laws = [("stvk", elements.st_venant_kirchhoff(BLOCK, 1e4, 0.3)),
                ("hencky q2", elements.hencky(quadratic, 1e4, 0.3)), *averaged()]
        for name, parts in [*bodies(), *laws]:
            for seed, part in enumerate(parts):
                x, way = state(seed, quadratic if name == "hencky q2" else BLOCK)
                with self.subTest(name, part=type(part).__name__):
                    found = (part.hessian(x) @ way.ravel()).reshape(way.shape)
                    off = np.linalg.norm(slope(part.gradient, x, way) - found)
                    self.assertLess(off, 1e-6 * np.linalg.norm(found))

    def test_no_force_or_torque_on_a_free_body(self):
        for name, parts in bodies():
            x, _ = state(1)
            g = sum(part.gradient(x) for part in parts)
            size = np.abs(g).sum()
            with self.subTest(name):
                self.assertLess(np.abs(g.sum(axis=0)).max(), 1e-12 * size)
                self.assertLess(np.abs(np.cross(x, g).sum(axis=0)).max(), 1e-13 * size)


class Hypoelastic(unittest.TestCase):
    found = staticmethod(lambda: figures("hypoelastic", lambda row: row["case"]))

    def test_its_volume_is_henckys_to_a_thousandth(self):
        hencky = figures("elements", lambda row: tuple(row.values())[:-1])
        for strain in ("0.05", "0.2"):
            own = self.found()[f"compression {strain} nu 0.25 in 10 steps"]
            law = hencky["compression", strain, "hencky", "q1-sri", "0.25", "volume change"]
            self.assertLess(abs(own / law - 1), 1e-3)

    def test_its_torque_depends_on_the_steps(self):
        torque = [self.found()[f"torsion 45 nu 0.25 in {n} steps"] for n in (2, 4, 30)]
        self.assertGreater(torque[0], torque[1])
        self.assertGreater(torque[1], torque[2])


if __name__ == "__main__":
    unittest.main()
