"""Where steps of an integrator are stable: in the plane of Γ dt, and over damping."""

from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from method_style import NEUTRAL, TWO_COLUMNS, legend_below

_STABLE = "#DCE9F5"
_ON_PAPER = {"color": NEUTRAL[0], "linewidth": 1.1}
_FOUND = {"color": "#0072B2", "linestyle": "none", "marker": "o", "markersize": 3.2}
_OTHER = {"color": "#D55E00", "linestyle": "none", "marker": "x", "markersize": 4}


@dataclass
class Border:
    """Of a region in the plane of Γ dt, its upper half from ray to ray. angle: of the ray
    from the imaginary axis, positive to the left; radius: |Γ dt| found by stepping;
    on_paper: the same of the closed form. is_inside: whether it is the inside that is stable."""

    title: str
    angle: np.ndarray
    radius: np.ndarray
    on_paper: np.ndarray
    is_inside: bool


def _round(angles, radii):
    """Between rays the radius is interpolated, which keeps the border round. Where there is
    no ray along the imaginary axis the border touches the origin."""
    if angles[0] != 0:
        angles, radii = np.array([0, *angles]), np.array([0, *radii])
    angle = np.linspace(angles[0], angles[-1], 200)
    order = np.argsort(angles)
    return angle, np.interp(angle, angles[order], radii[order])


def draw_plane(borders):
    """A panel for each integrator."""
    figure = Figure((TWO_COLUMNS, 2.7))
    for axes, border in zip(figure.subplots(1, len(borders), squeeze=False)[0], borders):
        angle, radius = _round(border.angle, border.on_paper)
        x, y = -radius * np.sin(angle), radius * np.cos(angle)
        outline = np.concatenate([x, x[::-1]]), np.concatenate([y, -y[::-1]])
        axes.set_facecolor("white" if border.is_inside else _STABLE)
        axes.fill(*outline, color=_STABLE if border.is_inside else "white", zorder=0.6)
        axes.plot(x, y, label="border on paper", **_ON_PAPER)
        axes.plot(x, -y, **_ON_PAPER)
        found = -border.radius * np.sin(border.angle), border.radius * np.cos(border.angle)
        axes.plot(*found, label="border found by stepping", **_FOUND)
        axes.plot(found[0], -found[1], **_FOUND)
        for at in (axes.axhline, axes.axvline):
            at(0, color=NEUTRAL[1], linewidth=0.6, zorder=0.8)
        reach = 1.25 * max(np.abs(x).max(), np.abs(y).max())
        _name_regions(axes, x, reach, border.is_inside)
        axes.set(xlim=(-reach, reach), ylim=(-reach, reach), aspect="equal", title=border.title)
        axes.set(xlabel="Re Γ dt [-]")
    figure.axes[0].set_ylabel("Im Γ dt [-]")
    legend_below(figure)
    return figure


def _name_regions(axes, x, reach, is_inside):
    """Inside and outside; x: of the border."""
    is_slim = np.ptp(x) < 1
    names = ("stable", "unstable") if is_inside else ("unstable", "stable")
    style = {"ha": "center", "va": "center", "fontsize": 7}
    inside = (x.min() + x.max()) / 2, 0 if is_slim else 0.25
    axes.text(*inside, names[0], rotation=90 if is_slim else 0, **style)
    axes.text(-np.sign(np.mean(x)) * reach / 2, 0.25, names[1], **style)


def draw_over_damping(zeta, on_paper, found):
    """on_paper: the largest stable ω dt at each ζ. found: (name, ζ, ω dt) of each
    integrator, by stepping."""
    figure = Figure((0.55 * TWO_COLUMNS, 2.7))
    axes = figure.subplots()
    axes.fill_between(zeta, on_paper, color=_STABLE, zorder=0.6)
    axes.plot(zeta, on_paper, label="2(√(1 + ζ²) − ζ), on paper", **_ON_PAPER)
    for (name, x, y), style in zip(found, (_FOUND | {"mfc": "none", "markersize": 5}, _OTHER)):
        axes.plot(x, y, label=f"{name}, found by stepping", **style)
    axes.text(0.12 * zeta[-1], 0.35, "stable", fontsize=7)
    axes.text(0.55 * zeta[-1], 1.3, "unstable", fontsize=7)
    axes.set(xlabel="damping ratio ζ [-]", ylabel="ω dt [-]")
    axes.set(xlim=(0, zeta[-1]), ylim=(0, 1.1 * max(on_paper)))
    legend_below(figure, columns=1)
    return figure
