"""Printed figures and ours on one glance."""

import numpy as np
from matplotlib.figure import Figure
from method_style import TWO_COLUMNS, legend_below, line, plain_numbers


def draw(tables):
    """tables: (title, printed unit, unit of the difference, {method: (printed, difference, usable)}).
    Differences of ours from printed figures over the printed ones; hollow where the state
    is not one to compare."""
    figure = Figure((TWO_COLUMNS, 2.5))
    all_axes = figure.subplots(1, len(tables), squeeze=False)[0]
    for axes, (title, printed_unit, unit, methods) in zip(all_axes, tables):
        for name, (printed, difference, usable) in methods.items():
            style = {**line(name), "linestyle": "none", "markersize": 4.5}
            del style["markerfacecolor"]
            usable = np.asarray(usable, dtype=bool)
            for chosen, face in ((usable, style["color"]), (~usable, "none")):
                if chosen.any():
                    label = name if face != "none" else None
                    x, y = np.asarray(printed)[chosen], np.asarray(difference)[chosen]
                    axes.plot(x, y, mfc=face, label=label, **style)
        axes.axhline(0, color="#888888", linewidth=0.7)
        axes.margins(y=0.1)
        axes.set_yscale("symlog", linthresh=0.1 if unit == "points" else 1, linscale=1)
        plain_numbers(axes.yaxis)
        axes.set(title=title, xlabel=f"printed [{printed_unit}]", ylabel=f"ours − printed [{unit}]")
    legend_below(figure)
    return figure
