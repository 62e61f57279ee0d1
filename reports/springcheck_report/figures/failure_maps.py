"""Where a method fails over two settings: a field for each case, limits and theory over it."""

from dataclasses import dataclass, field

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, PathPatch
from matplotlib.patheffects import withStroke
from matplotlib.path import Path
from method_style import FAILURE_STYLES, NOT_COMPUTED, TWO_COLUMNS, legend_below, plain_numbers

_PANEL_HEIGHT = 2.15  # inches
_POINTS = 72  # to an inch
_LEAST_LETTER = 3.5  # points, below which nobody reads it
_MOST_LETTER = 6.5
_HALO = [withStroke(linewidth=2.6, foreground="white")]


@dataclass
class Axis:
    """A setting's values in order. positions: where they stand, ascending; is_log: on a
    logarithmic axis. texts: of the ticks where values are no numbers, else None."""

    label: str
    positions: np.ndarray
    is_log: bool = False
    texts: list | None = None

    def edges(self):
        """Borders of the fields about the values, one more than these: half way to the
        neighbours, and as far beyond the ends."""
        at = np.log(self.positions) if self.is_log else np.asarray(self.positions, dtype=float)
        if len(at) == 1:
            return self.positions[0] + np.array([-0.5, 0.5])  # any width will do
        middles = (at[1:] + at[:-1]) / 2
        edges = np.array([2 * at[0] - middles[0], *middles, 2 * at[-1] - middles[-1]])
        if self.is_log:
            return np.exp(edges)
        if self.texts is None and at[0] >= 0:
            edges[0] = max(edges[0], 0)  # a field of strains does not reach below none
        return edges


@dataclass
class Line:
    """x, y: positions on the axes, NaN where the line is broken."""

    label: str
    x: np.ndarray
    y: np.ndarray


@dataclass
class Panel:
    """failures: [row of the vertical axis][column of the other], names as in
    FAILURE_STYLES, None where there is no case yet. limit: the Line that was found, or None.
    theory: Lines."""

    title: str
    failures: list
    limit: Line | None = None
    theory: list = field(default_factory=list)


def draw(vertical, horizontal, panels, letters):
    """A panel for each method. letters: of failures by name; where fields are too small for
    them, hatches tell failures apart from each other without their colours."""
    columns = min(3, len(panels)) if len(panels) != 4 else 2
    rows = -(-len(panels) // columns)
    width = TWO_COLUMNS if columns > 1 else 0.6 * TWO_COLUMNS
    figure = Figure((width, _PANEL_HEIGHT * rows + 0.35))
    grid = figure.subplots(rows, columns, squeeze=False, sharex=True, sharey=True)
    seen = {}
    letter_size = _letter_size(vertical, horizontal, columns)
    dashes = _dashes_by_label(panels)
    for place, axes in enumerate(grid.flat):
        if place >= len(panels):
            axes.set_visible(False)
            continue
        panel = panels[place]
        _fields(axes, vertical, horizontal, panel, letters, letter_size, seen)
        _lines(axes, panel, dashes, horizontal.texts is None)
        _scales(axes, vertical, horizontal, columns)
        axes.set_title(panel.title)
        if place % columns == 0:
            axes.set_ylabel(vertical.label)
        if place + columns >= len(panels):
            axes.set_xlabel(horizontal.label)
            axes.tick_params(labelbottom=True)
    legend_below(figure, columns=4 if columns > 1 else 3, further=_legend(seen, panels, letters, letter_size, dashes))
    return figure


def _letter_size(vertical, horizontal, columns):
    """Points of the letters in fields of median size, None where they would be too small."""
    width = 0.8 * TWO_COLUMNS / max(columns, 1.7) * _POINTS
    height = 0.75 * _PANEL_HEIGHT * _POINTS
    size = min(_MOST_LETTER, width / len(horizontal.positions) / 0.9, height / len(vertical.positions) / 1.3)
    return size if size >= _LEAST_LETTER else None


def _fields(axes, vertical, horizontal, panel, letters, letter_size, seen):
    """One patch for each kind of failure, of all its fields; adds to `seen` what is drawn."""
    x, y = horizontal.edges(), vertical.edges()
    corners = {}
    for i, row in enumerate(panel.failures):
        for j, failure in enumerate(row):
            corners.setdefault(failure, []).append((x[j], x[j + 1], y[i], y[i + 1]))
            if failure is not None and letter_size:
                place = horizontal.positions[j], vertical.positions[i]
                _letter(axes, place, failure, letters[failure], letter_size)
    for failure, rectangles in corners.items():
        colour, hatch, _ = FAILURE_STYLES.get(failure, NOT_COMPUTED)
        shape = _compound(rectangles)
        border = 0.5 if letter_size else 0
        axes.add_patch(PathPatch(shape, facecolor=colour, edgecolor="white", linewidth=border))
        if hatch and (letter_size is None or failure is None):
            hatched = {"edgecolor": _hatch_colour(failure), "hatch": hatch, "linewidth": 0}
            axes.add_patch(PathPatch(shape, facecolor="none", **hatched))
        seen[failure] = None
    axes.set(xlim=(x[0], x[-1]), ylim=(y[0], y[-1]))


def _hatch_colour(failure):
    ink = FAILURE_STYLES.get(failure, NOT_COMPUTED)[2]
    return "#DDDDDD" if ink == "white" else "#444444"


def _letter(axes, place, failure, letter, size):
    colour, _, ink = FAILURE_STYLES[failure]
    # Above the lines, but for the dots of what does not fail.
    style = {"color": ink, "fontsize": size, "ha": "center", "va": "center", "zorder": 1.5}
    if failure != "none":
        style |= {"zorder": 7, "path_effects": [withStroke(linewidth=1.4, foreground=colour)]}
    axes.text(*place, letter, **style)


def _compound(rectangles):
    """(x0, x1, y0, y1) of each as one path."""
    points, codes = [], []
    for x0, x1, y0, y1 in rectangles:
        points += [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)]
        codes += [Path.MOVETO, Path.LINETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY]
    return Path(points, codes)


_MOST_MARKERS = 30
_LIMIT = {"color": "black", "linewidth": 1.3, "marker": "o", "markersize": 3, "markerfacecolor": "white"}
_DASHES = [(0, (5, 3)), (0, (1.5, 1.5)), (0, (8, 2, 1.5, 2))]


def _dashes_by_label(panels):
    """A theory looks the same in all panels."""
    labels = dict.fromkeys(line.label for panel in panels for line in panel.theory)
    return {label: _DASHES[i % len(_DASHES)] for i, label in enumerate(labels)}


def _lines(axes, panel, dashes, is_connected):
    """Theory lies over the limit that was found and below its markers, so that both are seen
    where they agree. Between values that are no numbers there is no line."""
    if panel.limit:
        at = panel.limit.x, panel.limit.y
        if is_connected:
            axes.plot(*at, path_effects=_HALO, zorder=4, **_LIMIT | {"marker": ""})
        if not is_connected or len(panel.limit.x) <= _MOST_MARKERS:
            axes.plot(*at, zorder=6, **_LIMIT | {"linestyle": ""})
    for line in panel.theory:
        for style in _theory_styles(dashes[line.label]):
            axes.plot(line.x, line.y, zorder=5, **style)


def _theory_styles(dashes):
    """White dashes on black, which are seen on any field."""
    return (
        {"color": "black", "linewidth": 2, "solid_capstyle": "butt"},
        {"color": "white", "linewidth": 1, "linestyle": dashes, "dash_capstyle": "butt"},
    )


def _scales(axes, vertical, horizontal, columns):
    # The limits that the fields have set are kept: scales and ticks would widen them.
    limits = axes.get_xlim(), axes.get_ylim()
    for axis, set_scale, name, positions in (
        (horizontal, axes.set_xscale, axes.xaxis, horizontal.positions),
        (vertical, axes.set_yscale, axes.yaxis, vertical.positions),
    ):
        if axis.is_log:
            set_scale("log")
            plain_numbers(name)
        if axis.texts is not None:
            name.set_ticks(positions, axis.texts)
    if horizontal.texts is not None and sum(len(text) + 2 for text in horizontal.texts) > 96 / columns:
        axes.tick_params(axis="x", labelrotation=45)
    axes.set(xlim=limits[0], ylim=limits[1])
    axes.grid(False)


def _legend(seen, panels, letters, letter_size, dashes):
    entries = []
    for failure, (colour, hatch, _) in FAILURE_STYLES.items():
        if failure in seen:
            hatched = hatch if letter_size is None else None
            patch = Patch(facecolor=colour, edgecolor=_hatch_colour(failure), hatch=hatched, linewidth=0.4)
            entries.append((patch, f"{letters[failure]}  {failure}" if letter_size else failure))
    if None in seen:
        colour, hatch, _ = NOT_COMPUTED
        patch = Patch(facecolor=colour, edgecolor="#444444", hatch=hatch, linewidth=0.4)
        entries.append((patch, "not computed"))
    if any(panel.limit for panel in panels):
        entries.append((Line2D([], [], **_LIMIT), "limit that was found"))
    for label, pattern in dashes.items():
        entries.append((tuple(Line2D([], [], **style) for style in _theory_styles(pattern)), label))
    return entries
