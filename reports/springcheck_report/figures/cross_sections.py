"""Meshes of springs and finite elements laid over each other in a plane (figures 5.11 and
5.13 of the thesis)."""

from dataclasses import dataclass

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from method_style import TWO_COLUMNS, colour, legend_below


@dataclass
class Section:
    """bodies: method's name and its lines in the plane, segments x 2 x 2 [cm]."""

    title: str
    bodies: list


def draw(sections, horizontal, vertical):
    """A panel for each Section; the first body's lines are drawn wide and pale, so that a
    second body that agrees covers them."""
    figure = Figure((TWO_COLUMNS, TWO_COLUMNS / max(len(sections), 2) + 0.55))
    panels = figure.subplots(1, len(sections), squeeze=False)[0]
    for axes, section in zip(panels, sections):
        for i, (name, segments) in enumerate(section.bodies):
            axes.add_collection(
                LineCollection(
                    segments,
                    colors=colour(name),
                    linewidths=2.2 if i == 0 else 0.7,
                    alpha=0.35 if i == 0 else 1,
                    label=name,
                )
            )
        points = np.concatenate([segments.reshape(-1, 2) for _, segments in section.bodies])
        margin = 0.03 * (points.max(axis=0) - points.min(axis=0)).max()
        low, high = points.min(axis=0) - margin, points.max(axis=0) + margin
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
        axes.set(xlabel=horizontal, ylabel=vertical, title=section.title)
        axes.grid(False)
    legend_below(figure)
    return figure
