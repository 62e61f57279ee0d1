"""Springs and finite elements on any cells: errors by mesh and method."""

import numpy as np
from matplotlib.figure import Figure
from method_style import TWO_COLUMNS, line


def draw(meshes, panels, x_label):
    """panels: (title, {method: errors by mesh, NaN where it has none}). One line of dots
    per mesh, on a symmetric logarithmic axis."""
    figure = Figure((TWO_COLUMNS, 0.27 * len(meshes) + 1.2))
    all_axes = figure.subplots(1, len(panels), sharey=True, squeeze=False)[0]
    entries = {}
    for axes, (title, methods) in zip(all_axes, panels):
        for i, (name, errors) in enumerate(methods.items()):
            style = {**line(name), "linestyle": "none", "markersize": 4}
            offset = 0.5 * (i - (len(methods) - 1) / 2) / len(methods)
            places = np.arange(len(meshes)) + offset
            entries.setdefault(name, axes.plot(errors, places, **style)[0])
        axes.axvline(0, color="#888888", linewidth=0.7)
        axes.set_xscale("symlog", linthresh=5)
        axes.set(title=title, xlabel=x_label, ylim=(len(meshes) - 0.5, -0.5))
    all_axes[0].set_yticks(range(len(meshes)), meshes)
    figure.legend(list(entries.values()), list(entries), loc="upper center", ncols=4,
                  bbox_to_anchor=(0.5, 0))
    return figure
