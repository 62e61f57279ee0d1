"""Measures against a setting: Poisson's ratio, deformation, cells."""

from dataclasses import dataclass, field

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator
from method_style import OTHER_RING, RINGS, TWO_COLUMNS, legend_below, line, plain_numbers


@dataclass
class Curve:
    """A method's values along x; NaN where a case has no measure. statuses: of each
    case; other than ok they are marked. style: keywords of plot, the method's own if none."""

    name: str
    x: np.ndarray
    y: np.ndarray
    statuses: list = field(default_factory=list)
    style: dict | None = None


@dataclass
class Panel:
    title: str
    x_label: str
    y_label: str
    curves: list
    log_x: bool = False
    log_y: bool = False
    symmetric_log_y: bool = False  # linear within 1
    from_zero: bool = False  # the axis of y


def draw(panels, size=(TWO_COLUMNS, 2.75), columns=5):
    """One row of panels with one legend, of so many columns. size: inches. A cross below the panel's
    floor tells of a case without any equilibrium, a ring around a marker of one that is not ok."""
    figure = Figure(size)
    all_axes = figure.subplots(1, len(panels), squeeze=False)[0]
    statuses = set()
    for axes, panel in zip(all_axes, panels):
        for curve in panel.curves:
            axes.plot(curve.x, curve.y, label=curve.name, **(curve.style or line(curve.name)))
        if panel.log_x:
            _log_axis_of_values(axes, panel.curves)
        if panel.log_y:
            axes.set_yscale("log")
            low, high = axes.get_ylim()
            if high < 100 * low:  # powers of ten alone would leave one tick or two
                axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
            plain_numbers(axes.yaxis)
        if panel.symmetric_log_y:
            axes.set_yscale("symlog", linthresh=1)
            plain_numbers(axes.yaxis)
        axes.set(title=panel.title, xlabel=panel.x_label, ylabel=panel.y_label)
        if panel.from_zero:
            axes.set_ylim(0, 1.08 * max(np.nanmax(curve.y) for curve in panel.curves))
        for curve in panel.curves:
            statuses |= _mark_statuses(axes, curve)
    legend_below(figure, columns, further=[_status_entry(*status) for status in sorted(statuses)])
    return figure


def _log_axis_of_values(axes, curves):
    """A logarithmic axis, its ticks at the values there are if these are few."""
    axes.set_xscale("log")
    plain_numbers(axes.xaxis)
    values = np.unique(np.concatenate([curve.x for curve in curves]))
    if len(values) <= 8:
        axes.set_xticks(values, [f"{value:.0f}" if value >= 1000 else f"{value:.3g}" for value in values])
        axes.set_xticks([], minor=True)


def _mark_statuses(axes, curve):
    """Rings around values of cases that are not ok, crosses of the curve's own colour where
    there is no value. Returns {(status, whether it has values)}."""
    found = set()
    own = (curve.style or line(curve.name))["color"]
    for x, y, status in zip(curve.x, curve.y, curve.statuses):
        if status == "ok":
            continue
        found.add((status, bool(np.isfinite(y))))
        if np.isfinite(y):
            axes.plot([x], [y], **_ring(status), zorder=5)
        else:
            floor = {"transform": axes.get_xaxis_transform(), "clip_on": False, "zorder": 5}
            axes.plot([x], [0], "x", markersize=5, color=own, **floor)
    return found


def _ring(status):
    ring = {"marker": RINGS.get(status, OTHER_RING), "mfc": "none", "mec": "#222222", "mew": 0.8}
    return {**ring, "markersize": 7, "linestyle": "none"}


def _status_entry(status, has_values):
    """(handle, label) for the legend."""
    name = status.replace("_", " ")
    if has_values:
        return Line2D([], [], **_ring(status)), name
    return Line2D([], [], ls="none", marker="x", color="#555555"), f"{name} (method's colour)"
