"""How cases ended, by method and load: where methods fail."""

from matplotlib.figure import Figure
from matplotlib.patches import Patch, Rectangle
from method_style import STATUS_COLOURS, TWO_COLUMNS, legend_below


def draw(rows, columns, shares):
    """rows, columns: names of methods and of groups of cases; shares[row][column]: {status:
    number of cases}. Every place of the map is a bar of its cases' statuses."""
    figure = Figure((TWO_COLUMNS, 0.24 * len(rows) + 1.3))
    axes = figure.subplots()
    seen = set()
    for i, row in enumerate(shares):
        for j, counts in enumerate(row):
            total, start = sum(counts.values()), 0.0
            for status in STATUS_COLOURS:
                share = 0.94 * counts.get(status, 0) / max(total, 1)
                if share == 0:
                    continue
                seen.add(status)
                axes.add_patch(
                    Rectangle((j + 0.03 + start, i + 0.1), share, 0.8, fc=STATUS_COLOURS[status])
                )
                start += share
            if total:
                ok = counts.get("ok", 0)
                axes.text(j + 0.5, i + 0.5, f"{ok}/{total}", ha="center", va="center", fontsize=6)
    axes.set(xlim=(0, len(columns)), ylim=(len(rows), 0))
    axes.set_xticks([j + 0.5 for j in range(len(columns))], columns)
    axes.set_yticks([i + 0.5 for i in range(len(rows))], rows)
    axes.tick_params(length=0)
    axes.grid(False)
    axes.spines[:].set_visible(False)
    axes.xaxis.tick_top()
    patches = [
        (Patch(color=STATUS_COLOURS[status]), status.replace("_", " "))
        for status in STATUS_COLOURS
        if status in seen
    ]
    legend_below(figure, columns=8, further=patches)
    return figure
