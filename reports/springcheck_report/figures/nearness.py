"""Accuracy against time in one panel: the Pareto front, and the models on it before all others."""

from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from method_style import legend_below, plain_numbers
from figures.work_precision import FRONT, style

_CONTEXT = "#D0D0D0"


def draw(size, time_label, error_label, points, front, errors_told, levels):
    """points: work_precision.Point with `errors` of one measure alone, none failed or unknown; front:
    those on it, from the fastest to the most accurate, and the errors [%] that they count with. levels:
    errors [%] that a line marks."""
    figure = Figure(size)
    axes = figure.subplots()
    axes.set(xscale="log", yscale="log", xlabel=time_label, ylabel=error_label)
    for level in levels:
        axes.axhline(level, color="#777777", linewidth=0.7, linestyle=":")
    axes.plot([p.time for p in points], [_error(p) for p in points], "o", color=_CONTEXT, markersize=2.2)
    models = list(dict.fromkeys(point.model for point in front))
    for model in models:
        own = sorted((p for p in points if p.model == model), key=lambda p: p.across)
        axes.plot([p.time for p in own], [_error(p) for p in own], **style(model) | {"label": model.name})
    low, high = axes.get_xlim(), axes.get_ylim()
    x = [*(point.time for point in front), low[1]]
    axes.step(x, [*errors_told, errors_told[-1]], where="post", zorder=1.5, **FRONT)
    axes.set(xlim=low, ylim=high)
    for axis in (axes.xaxis, axes.yaxis):
        plain_numbers(axis)
    front_entry = Line2D([], [], **FRONT), "Pareto front"
    others = Line2D([], [], ls="none", marker="o", color=_CONTEXT, markersize=2.2), "all other models"
    legend_below(figure, columns=3, further=[front_entry, others])
    return figure


def _error(point):
    (error,) = point.errors.values()
    return error
