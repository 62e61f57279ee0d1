"""Several series row by row: how far each is off a common zero."""

import numpy as np
from matplotlib.figure import Figure
from method_style import TWO_COLUMNS, legend_below, plain_numbers

_ROW = 0.2  # inches


def draw(panels, styles, linear_within=None):
    """panels: (title, labels of the rows, x_label, {series: values, NaN where there is
    none}). styles: keywords of plot by series. The axis is
    linear, or symmetric logarithmic and linear within a number."""
    most = max(len(labels) for _, labels, _, _ in panels)
    figure = Figure((TWO_COLUMNS, _ROW * most + 1.1))
    all_axes = figure.subplots(1, len(panels), squeeze=False)[0]
    for axes, (title, labels, x_label, series) in zip(all_axes, panels):
        for name, values in series.items():
            style = {**styles[name], "linestyle": "none"}
            axes.plot(values, np.arange(len(labels)), label=name, **style)
        axes.axvline(0, color="#888888", linewidth=0.7)
        if linear_within:
            _symmetric_log_axis(axes, linear_within, series)
        axes.set_yticks(range(len(labels)), labels)
        axes.set(title=title, xlabel=x_label, ylim=(len(labels) - 0.5, -0.5))
    legend_below(figure)
    return figure


def _symmetric_log_axis(axes, linear_within, series):
    axes.set_xscale("symlog", linthresh=linear_within)
    decades = linear_within * 10.0 ** np.arange(4)
    axes.set_xticks([*-decades[::-1], 0, *decades])
    plain_numbers(axes.xaxis)
    ends = np.concatenate([[-2 * linear_within, 2 * linear_within], *series.values()])
    axes.set_xlim(2 * np.nanmin(ends), 2 * np.nanmax(ends))
