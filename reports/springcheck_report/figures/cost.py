"""Error against time with the Pareto front, and time against cells."""

import numpy as np
from matplotlib.figure import Figure
from method_style import TWO_COLUMNS, legend_below, line, plain_numbers


def pareto_front(times, errors):
    """Places of the points that no other beats in both, in the order of time."""
    front, best = [], np.inf
    for place in np.lexsort((errors, times)):
        if errors[place] < best:
            front.append(place)
            best = errors[place]
    return front


def draw(error_panel, time_panel):
    """error_panel: (label of the error, {method: (seconds, errors)}), time_panel:
    {method: (cells, seconds)}; either may be None."""
    figure = Figure((TWO_COLUMNS, 2.9))
    present = [panel for panel in (error_panel, time_panel) if panel]
    all_axes = list(figure.subplots(1, len(present), squeeze=False)[0])
    if error_panel:
        axes = all_axes.pop(0)
        label, methods = error_panel
        for name, (seconds, errors) in methods.items():
            axes.loglog(seconds, errors, label=name, **line(name))
        seconds = np.concatenate([methods[name][0] for name in methods])
        errors = np.concatenate([methods[name][1] for name in methods])
        front = pareto_front(seconds, errors)
        wide = {"color": "#CC3311", "linewidth": 3, "alpha": 0.25, "label": "Pareto front"}
        axes.step(seconds[front], errors[front], where="post", **wide)
        plain_numbers(axes.xaxis)
        plain_numbers(axes.yaxis)
        axes.set(xlabel="time of the solution [s]", ylabel=label, title="Error against time")
    if time_panel:
        axes = all_axes.pop(0)
        for name, (cells, seconds) in time_panel.items():
            axes.loglog(cells, seconds, label=name, **line(name))
        plain_numbers(axes.xaxis)
        plain_numbers(axes.yaxis)
        axes.set(xlabel="cells", ylabel="time of the solution [s]", title="Time against cells")
    legend_below(figure)
    return figure
