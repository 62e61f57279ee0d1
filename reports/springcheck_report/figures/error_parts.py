"""Where errors come from: law and discretisation."""

import numpy as np
from matplotlib.figure import Figure
from method_style import NEUTRAL, TWO_COLUMNS, legend_below, plain_numbers, shades


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


_SMALLEST = 1e-3  # percent


def draw_law_parts(names, panels):
    """panels: title and dots, each the place of its name, nu, law part and bar, both in
    percent of the reference and without sign."""
    figure = Figure((TWO_COLUMNS, 0.2 * len(names) + 1.1))
    all_axes = figure.subplots(1, len(panels), sharex=True, sharey=True, squeeze=False)[0]
    ratios = sorted({nu for _, dots in panels for _, nu, _, _ in dots})
    colours = dict(zip(ratios, shades(len(ratios))))
    for axes, (title, dots) in zip(all_axes, panels):
        for place, nu, part, bar in dots:
            is_known = bar is not None and part > bar
            drawn = max(part, 0 if is_known else bar or 0, _SMALLEST)
            offset = 0.22 * (ratios.index(nu) - (len(ratios) - 1) / 2)
            style = {"color": colours[nu], "markerfacecolor": colours[nu] if is_known else "white"}
            axes.plot(drawn, place + offset, "o", markersize=3, clip_on=False, **style)
        axes.set(title=title, xscale="log", xlim=(_SMALLEST, 100), xlabel="% of the reference")
        plain_numbers(axes.xaxis)
        axes.set_xticks([_SMALLEST, 0.1, 10])
        axes.set_ylim(len(names) - 0.5, -0.5)
    all_axes[0].set_yticks(range(len(names)), names)
    for nu, colour in colours.items():
        all_axes[0].plot([], [], "o", color=colour, markersize=3, label=f"nu {nu:g}")
    legend_below(figure)
    return figure
