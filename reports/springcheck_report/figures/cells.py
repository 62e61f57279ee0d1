"""Springs and finite elements on any cells: errors by mesh and method."""

import numpy as np
from matplotlib.figure import Figure
from method_style import TWO_COLUMNS, legend_below, line, plain_numbers


def _limits(methods):
    """A little beyond the outermost errors, and never less than ±6 %."""
    errors = np.concatenate([[-6, 6], *methods.values()])
    return 1.4 * np.nanmin(errors), 1.4 * np.nanmax(errors)


def draw(meshes, panels, x_label):
    """panels: (title, {method: errors by mesh, NaN where it has none}). One line of dots
    per mesh, on a symmetric logarithmic axis."""
    figure = Figure((TWO_COLUMNS, 0.27 * len(meshes) + 1.2))
    all_axes = figure.subplots(1, len(panels), sharey=True, squeeze=False)[0]
    for axes, (title, methods) in zip(all_axes, panels):
        for i, (name, errors) in enumerate(methods.items()):
            style = {**line(name), "linestyle": "none", "markersize": 4}
            offset = 0.5 * (i - (len(methods) - 1) / 2) / len(methods)
            places = np.arange(len(meshes)) + offset
            axes.plot(errors, places, label=name, **style)
        axes.axvline(0, color="#888888", linewidth=0.7)
        axes.margins(x=0.08)
        axes.set_xscale("symlog", linthresh=5)
        axes.set_xticks([-100, -20, -5, 0, 5, 20, 100, 400], minor=False)
        plain_numbers(axes.xaxis)
        axes.set_xlim(*_limits(methods))
        axes.set(title=title, xlabel=x_label, ylim=(len(meshes) - 0.5, -0.5))
    all_axes[0].set_yticks(range(len(meshes)), meshes)
    legend_below(figure, columns=4)
    return figure
