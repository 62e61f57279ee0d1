"""Figures at equilibrium: forces, torques, volumes and deflections."""

from functools import partial

import elements
import numpy as np
from blocks import (Block, equilibrium, plate_force, plate_torque, shifted, turned,
                    volume_change)
from energies import Stars
from springs import affine, lattice

E = 1e4
CUBE = Block((0.05, 0.05, 0.05), (10, 10, 10))
COARSE = Block((0.05, 0.05, 0.05), (5, 5, 5))
SMALL_BEAM = Block((0.004, 0.004, 0.024), (4, 4, 24))


def pressed(strain):
    return "compression", strain, lambda block: shifted((0, 0, -strain * block.size[2]))


def pulled(strain):
    return "tension", strain, lambda block: shifted((0, 0, strain * block.size[2]))


def sheared(strain):
    return "shearing", strain, lambda block: shifted((strain * block.size[2], 0, 0))


def twisted(degrees):
    return "torsion", degrees, lambda block: turned(np.radians(degrees))


def figures_of(name, block, parts, load, small_strain=False):
    """Of one state: the force on the plate along the load and its norm, or the torque;
    and the change of volume."""
    test, amount, motion = load
    step = 12 if test == "torsion" else 0.05
    state = equilibrium(block, parts, motion(block), steps=int(np.ceil(amount / step)))
    case = f"{test} {amount:g} {name}"
    force = plate_force(block, state)
    along = force[0] if test == "shearing" else force[2]
    if test == "torsion":
        yield case, "torque", plate_torque(block, state, small_strain)
    else:
        yield case, "force", abs(along)
        yield case, "norm of force", float(np.linalg.norm(force))
    yield case, "volume change", volume_change(block, state)


def plates():
    """mss-cf on the thesis's cube and beam."""
    def springs(block, nu, form, load):
        name = f"mss-cf {form} nu {nu:g}"
        return figures_of(name, block, lattice(block, "mss-cf", E, nu, form), load)

    for nu in (0, 0.25, 0.499):
        for strain in (0.05, 0.2):
            yield from springs(CUBE, nu, "mu", pressed(strain))
            if nu > 0:
                yield from springs(SMALL_BEAM, nu, "mu", pulled(strain))
    yield from springs(SMALL_BEAM, 0, "mu", pulled(0.05))
    for strain in (0.05, 0.2):
        yield from springs(CUBE, 0, "E", pressed(strain))
        yield from springs(CUBE, 0.25, "mu", sheared(strain))
    for degrees in (1, 45):
        yield from springs(CUBE, 0.25, "mu", twisted(degrees))


LAWS = {("hooke", "q1"): elements.hooke,
        ("hooke", "q1-sri"): elements.hooke_parted,
        ("stvk", "q1"): elements.st_venant_kirchhoff,
        ("stvk", "q1-sri"): elements.st_venant_kirchhoff_parted,
        ("hencky", "q1-sri"): elements.hencky_parted,
        ("cauchy-born", "q1"): elements.continuum_of_lattice,
        ("cauchy-born", "q1-sri"): elements.continuum_of_lattice_parted}


def trilinear():
    """Elements of every law, on the cells of the thesis."""
    def rows(law, element, nu, block, load):
        parts = LAWS[law, element](block, E, nu)
        for _, quantity, value in figures_of("", block, parts, load, small_strain=law == "hooke"):
            yield load[0], load[1], law, element, nu, quantity, value

    ratios = 0, 0.25, 0.499
    for law, element in (("hooke", "q1"), ("hooke", "q1-sri"), ("stvk", "q1-sri"),
                         ("hencky", "q1-sri")):
        for nu in ratios:
            for strain in (0.05, 0.2):
                yield from rows(law, element, nu, CUBE, pressed(strain))
                if nu < 0.4 or law != "stvk":
                    yield from rows(law, element, nu, SMALL_BEAM, pulled(strain))
    for law, element in LAWS:
        for load in (sheared(0.05), sheared(0.2), twisted(1), twisted(45)):
            if law != "hooke" or load[1] in (0.05, 1):
                yield from rows(law, element, 0.25, CUBE, load)
    yield from rows("stvk", "q1", 0.25, CUBE, pressed(0.2))
    for nu in (0.49, 0.4999):  # volumetric locking
        yield from rows("hooke", "q1", nu, CUBE, pressed(0.05))
        yield from rows("hooke", "q1-sri", nu, CUBE, pressed(0.05))
    for element in ("q1", "q1-sri"):
        for nu in ratios:
            yield from rows("cauchy-born", element, nu, CUBE, pressed(0.05))
        yield from rows("cauchy-born", element, 0.25, CUBE, pressed(0.2))
        yield from rows("cauchy-born", element, 0.25, SMALL_BEAM, pulled(0.2))


QUADRATIC = {"hooke": elements.hooke,
             "stvk": elements.st_venant_kirchhoff,
             "hencky": elements.hencky,
             "cauchy-born": elements.continuum_of_lattice}
NODAL = {law: partial(parts_of, averaged=Stars)
         for (law, element), parts_of in LAWS.items() if element == "q1-sri"}


def quadratic_and_nodal():
    """q2 of every law on 4 x 4 x 4 cells, and q1-nodal on 5 x 5 x 5."""
    quadratic = Block(CUBE.size, (4, 4, 4), degree=2)
    # St-Venant's path may branch in compression at .499, and the continuum of mss-cf has
    # no equilibrium in tension at 0.
    ratios = {"hooke": (0, 0.25, 0.45, 0.499), "stvk": (0, 0.25, 0.45),
              "hencky": (0, 0.25, 0.45, 0.499), "cauchy-born": (0.25, 0.45)}
    for element, laws, block in (("q2", QUADRATIC, quadratic), ("q1-nodal", NODAL, COARSE)):
        for law, nu in ((law, nu) for law in laws for nu in ratios[law]):
            parts = laws[law](block, E, nu)
            for load in (pressed(0.05), pressed(0.2), pulled(0.2), sheared(0.2), twisted(45)):
                for _, quantity, value in figures_of("", block, parts, load,
                                                     small_strain=law == "hooke"):
                    yield load[0], load[1], law, element, nu, quantity, value


def bending():
    """Beams clamped at z = 0 under their weight, g = 10 along -x: drop of the tip."""
    def drop(size, across, parts_of, steps):
        block = Block(size, (across, across, 6 * across))
        weight = np.outer(block.masses(1000), [-10.0, 0, 0])
        state = equilibrium(block, parts_of(block), force=weight, steps=steps)
        return float(block.nodes[block.middle_of_top(), 0] - state.x[block.middle_of_top(), 0])

    metres, centimetres = (0.4, 0.4, 2.4), (0.004, 0.004, 0.024)
    # Only states that are one of a kind: mss-nfd at 2 MPa and on 8 cells wrinkles.
    for method, modulus, across in (("mss-cf", 10e6, 4), ("mss-cf", 10e6, 8),
                                    ("mss-cf", 2e6, 4), ("mss-cf", 2e6, 8),
                                    ("mss-nfd", 10e6, 4)):
        yield (f"{across} across {method} E {modulus:g}", "drop",
               drop(metres, across, lambda b: lattice(b, method, modulus, 0.25), 12))
    for law, element, across in (("hooke", "q1", 4), ("hooke", "q1", 8),
                                 ("hooke", "q1-sri", 4), ("hooke", "q1-sri", 8),
                                 ("stvk", "q1-sri", 4)):
        yield (f"{across} across in centimetres fem-{law} {element}", "drop",
               drop(centimetres, across, lambda b: LAWS[law, element](b, 2e6, 0.25), 1))


def small_strain():
    """Plate forces and torques at 1e-4, 5^3 cells; tips of cantilevers of one, two and
    four cells across."""
    strain = 1e-4
    for nu in (0, 0.25, 0.45, 0.499):
        bodies = {"mss-cf": lattice(COARSE, "mss-cf", E, nu),
                  "mss-affine": affine(COARSE, E, nu)}
        if nu > 0.25:
            bodies["mss-affine on cells"] = affine(COARSE, E, nu, stars=False)
        for name, parts in bodies.items():
            for test, _, motion in (pressed(strain), sheared(strain),
                                    ("torsion", strain, lambda block: turned(strain))):
                state = equilibrium(COARSE, parts, motion(COARSE))
                force = plate_force(COARSE, state)
                answer = (plate_torque(COARSE, state) if test == "torsion" else
                          abs(force[0 if test == "shearing" else 2]))
                yield f"{test} {name} nu {nu:g}", "force or torque", float(answer)

    thick, nu, pull = 0.01, 0.25, 1e-2
    for name, parts_of in (("mss-cf", lambda b: lattice(b, "mss-cf", E, nu)),
                           ("mss-affine", lambda b: affine(b, E, nu))):
        for across in (1, 2, 4):
            block = Block((thick, thick, 6 * thick), (across, across, 6 * across))
            # Nodes' shares of the end face go with their numbers of cells.
            shares = block.masses(1) * block.top
            force = np.outer(pull * thick**2 * shares / shares.sum(), [1.0, 0, 0])
            state = equilibrium(block, parts_of(block), force=force)
            yield (f"cantilever {name} {across} across", "mean deflection of the end",
                   float((state.x - block.nodes)[block.top, 0].mean()))


def strain_measures():
    """Springs of other strains, and elements of Hencky's law."""
    for nu in (0, 0.25, 0.4):
        parts = lattice(CUBE, "mss-cf", E, nu, measure="green")
        for load in (pressed(0.05), pressed(0.2), pulled(0.05), pulled(0.2), sheared(0.05),
                     sheared(0.2), twisted(1), twisted(45)):
            yield from figures_of(f"green nu {nu:g}", CUBE, parts, load)
    parts = lattice(CUBE, "mss-cf", E, 0.49, measure="green")
    for load in (pulled(0.05), pulled(0.2), sheared(0.05), twisted(1)):
        yield from figures_of("green nu 0.49", CUBE, parts, load)
    for nu in (0, 0.25, 0.4, 0.499):
        for name, parts in (
            ("logarithmic", lattice(COARSE, "mss-cf", E, nu, measure="logarithmic")),
            ("hencky", lattice(COARSE, "mss-cf", E, nu, measure="hencky")),
            ("fem-hencky q1-sri", elements.hencky_parted(COARSE, E, nu))):
            if name == "hencky" and nu > 0.45:
                continue  # without a use
            for load in (pressed(0.05), pressed(0.2), pulled(0.2), sheared(0.2), twisted(45)):
                yield from figures_of(f"{name} nu {nu:g}", COARSE, parts, load)
