"""Where errors come from: law and discretisation."""

import numpy as np
from matplotlib.figure import Figure
from method_style import NEUTRAL, TWO_COLUMNS, legend_below


def draw(labels, panels):
    """panels: (title, unit, law, law's bars, discretisation, its bars), one value per
    label; NaN where unresolved."""
    figure = Figure((TWO_COLUMNS, 0.3 * len(labels) + 1.1))
    all_axes = figure.subplots(1, len(panels), sharey=True, squeeze=False)[0]
    places = np.arange(len(labels))
    for axes, (title, unit, law, law_bar, mesh, mesh_bar) in zip(all_axes, panels):
        bars = {"height": 0.36, "error_kw": {"elinewidth": 0.8, "capsize": 1.5}}
        axes.barh(places - 0.19, law, xerr=law_bar, color=NEUTRAL[1], label="law", **bars)
        axes.barh(places + 0.19, mesh, xerr=mesh_bar, color="#CFCFCF", label="discretisation", **bars)
        axes.axvline(0, color="#444444", linewidth=0.7)
        axes.set(title=title, xlabel=unit, ylim=(len(labels) - 0.4, -0.6))
    all_axes[0].set_yticks(places, labels)
    legend_below(figure)
    return figure
