"""Golec's four springs: where the middle goes aside, and the loop under a load."""

import numpy as np
from matplotlib.figure import Figure
from method_style import NEUTRAL, TWO_COLUMNS, legend_below

_ON_PAPER = {"color": NEUTRAL[0], "linewidth": 1.2}
_HELD = {"color": "#0072B2", "linestyle": "none", "marker": "o", "markersize": 3.2}
_LOADED = {"grow": ("#D55E00", "s"), "back": ("#009E73", "^")}


def draw(held, loop):
    """held: zeta, centre, centre_on_paper, force and force_on_paper of states with A and B
    held, in order of zeta. loop: (whether the load grows, zeta, force) of each rest under a
    load, in the order they were reached. Lengths over l, forces over k l."""
    figure = Figure((TWO_COLUMNS, 2.9))
    aside, force = figure.subplots(1, 2)
    _draw_aside(aside, held)
    _draw_force(force, held, loop)
    for axes in (aside, force):
        for zeta in (-0.5, 0.5):
            axes.axvline(zeta, color=NEUTRAL[1], linewidth=0.7, linestyle=(0, (1, 2)))
        axes.set(xlabel="ζ, half the distance from B to A over l [-]")
    legend_below(figure, columns=3)
    return figure


def _draw_aside(axes, held):
    inside = np.abs(held["zeta"]) <= 0.5
    # On paper x^2 is linear in zeta^2: between rows nothing else is interpolated.
    zeta = np.linspace(-0.5, 0.5, 201)
    order = np.argsort(held["zeta"][inside] ** 2)
    squares = held["zeta"][inside][order] ** 2, held["centre_on_paper"][inside][order] ** 2
    x = np.sqrt(np.interp(zeta**2, *squares))
    for side in (1, -1):
        axes.plot(zeta, side * x, **_ON_PAPER)
        axes.plot(held["zeta"], side * held["centre"], **_HELD)
    reach = held["zeta"].max()
    for ends in ((-reach, -0.5), (0.5, reach)):
        axes.plot(ends, (0, 0), **_ON_PAPER)
    axes.plot((-0.5, 0.5), (0, 0), label="straight, unstable", **_ON_PAPER | {"linestyle": (0, (3, 2))})
    axes.set(ylabel="C aside, x/l [-]", title="Bifurcation at ζ = ±1/2")


def _draw_force(axes, held, loop):
    axes.plot(held["zeta"], held["force_on_paper"], label="on paper", **_ON_PAPER)
    axes.plot(held["zeta"], held["force"], label="A and B held, from the springs", **_HELD)
    grows, zeta, force = (np.array(column) for column in zip(*loop))
    steps = {"angles": "xy", "scale_units": "xy", "scale": 1, "width": 0.004, "color": "#AAAAAA", "zorder": 1}
    axes.quiver(zeta[:-1], force[:-1], np.diff(zeta), np.diff(force), **steps)
    for is_growing, name, label in ((True, "grow", "load grows"), (False, "back", "load goes back")):
        colour, marker = _LOADED[name]
        own = grows == is_growing
        style = {"color": colour, "marker": marker, "ls": "none", "markersize": 4, "mfc": "none"}
        axes.plot(zeta[own], force[own], label=label, **style)
    axes.set(ylabel="force F_A/(k l) [-]", title="Force, and the loop under a load")
