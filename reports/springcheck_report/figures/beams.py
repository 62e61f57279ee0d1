"""Centre lines of beams under gravity (figures 5.3 and 5.16 to 5.19 of the thesis)."""

from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from method_style import TWO_COLUMNS, legend_below


@dataclass
class CentreLine:
    """axial, drop: deformed position along the beam and below its rest line [m]; style:
    keywords of plot."""

    name: str
    axial: np.ndarray
    drop: np.ndarray
    style: dict


def draw(panels):
    """panels: (title, theory, lines), the last two lists of CentreLine; one legend for all."""
    figure = Figure((TWO_COLUMNS, 2.9))
    all_axes = figure.subplots(1, len(panels), squeeze=False)[0]
    largest = max(line.drop.max() for _, theory, lines in panels for line in [*theory, *lines])
    unit, factor = ("m", 1) if largest > 0.01 else ("mm", 1e3) if largest > 1e-3 else ("µm", 1e6)
    for axes, (title, theory, lines) in zip(all_axes, panels):
        for line in [*theory, *lines]:
            axes.plot(line.axial, -factor * line.drop, label=line.name, **line.style)
        axes.axhline(0, color="#BBBBBB", linewidth=0.6)
        axes.set(title=title, xlabel="along the beam [m]", ylabel=f"height [{unit}]")
    legend_below(figure, columns=4)
    return figure
