"""Error against time of every model: work and precision."""

from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Polygon
from matplotlib.ticker import FixedLocator
from method_style import TWO_COLUMNS, line

FRONT = {"color": "#CC3311", "linewidth": 3, "alpha": 0.25, "solid_joinstyle": "miter"}
_BAND = {"facecolor": "#E9E2CF", "edgecolor": "none", "zorder": -2}
_CONTEXT = "#D0D0D0"
_INK = "#444444"
_ROW_HEIGHT = 1.38  # inches
_FRONT_HEIGHT = 1.35  # rows: texts and the longest legend
_PANEL = 125, 120  # points of a panel's width and height, near enough to place texts by
_LANE = 0.1  # height of a status's lane, of the errors' own
_MOST_BELOW_BAR = 10  # an error that is so much smaller than the bar says nothing more
_MOST_TO_BAR = 30  # a bar that is so much smaller than all errors is told by its number
_SMALLEST_MARKER, _LARGEST_MARKER = 2.6, 6.2
# What tells a variant from the method's usual form, by what it is in.
_VARIANTS = {
    "element": {"q2": {"fillstyle": "top"}},
    "cell_type": {"tetrahedron": {"fillstyle": "left"}, "prism": {"fillstyle": "right"}},
    "precision": {"float": {"fillstyle": "bottom"}},
    "linear_solver": {"direct": {"marker": "*"}, "multigrid": {"marker": "*", "markerfacecolor": "white"}},
}


@dataclass(frozen=True)
class Model:
    """A way to simulate: what charts.json tells of it."""

    name: str
    method: str
    family: str
    element: str = ""
    cell_type: str = "hexahedron"
    linear_solver: str = ""
    precision: str = ""


@dataclass
class Point:
    """One model on one mesh. time, lower and upper quartile in the figure's unit; errors:
    by measure [%], None where unknown."""

    model: Model
    across: int
    threads: int
    status: str
    time: float
    lower: float
    upper: float
    errors: dict


@dataclass
class Measure:
    """A column: front: its points, from the fastest to the most accurate; errors_told: theirs [%], or
    what the truth may be off on their meshes where that is more; bar: what it may be off at most
    [%], None where unknown."""

    name: str
    title: str
    front: list
    errors_told: list
    bar: float | None


@dataclass
class Group:
    """A row: models that are told apart in it."""

    title: str
    models: list


@dataclass
class Block:
    """Rows against one truth: the front, then groups, each before all others in grey."""

    title: str
    points: list
    measures: list
    groups: list


def draw(time_label, blocks):
    """Columns: measures, the same in all blocks. One axis of time for all."""
    heights = [height for block in blocks for height in [_FRONT_HEIGHT, *(1 for _ in block.groups)]]
    widths = [1] * len(blocks[0].measures) + [0.68]
    figure = Figure((TWO_COLUMNS, _ROW_HEIGHT * sum(heights) + 0.75))
    ratios = {"width_ratios": widths, "height_ratios": heights}
    grid = figure.subplots(len(heights), len(widths), squeeze=False, **ratios)
    every = [p for block in blocks for p in [*block.points, *(p for m in block.measures for p in m.front)]]
    times = min(p.lower for p in every) / 1.5, max(p.upper for p in every) * 1.5
    sizes = marker_sizes(every)
    first = 0
    for block in blocks:
        _draw_block(grid[first : first + 1 + len(block.groups)], block, times, sizes)
        first += 1 + len(block.groups)
    for axes, measure in zip(grid[0], blocks[0].measures):
        axes.set_title(measure.title)
    for row in grid[:, :-1]:
        row[0].set_ylabel("error [%]")
        for axes in row:
            axes.tick_params(axis="x", labelbottom=False)
    for axes in grid[-1, :-1]:
        axes.tick_params(axis="x", labelbottom=True)
        axes.set_xlabel(time_label)
    _common_legend(figure, sizes, any(is_failed(p) for p in every))
    return figure


def _draw_block(grid, block, times, sizes):
    statuses = list(dict.fromkeys(p.status for p in block.points if is_failed(p)))
    for column, measure in enumerate(block.measures):
        scale = _scale(block.points, measure, statuses)
        for axes in grid[:, column]:
            _frame(axes, times, scale, block.points, measure)
            if column == 0:
                _name_lanes(axes, scale)
        _draw_front(grid[0, column], scale, measure, sizes)
        _name_bar(grid[0, column], measure)
        for axes, group in zip(grid[1:, column], block.groups):
            for model in group.models:
                _draw_model(axes, scale, measure, [p for p in block.points if p.model == model], sizes)
    on_front = list(dict.fromkeys(p.model for m in block.measures for p in m.front))
    _legend_beside(grid[0, -1], block.title, on_front, linestyle="none")
    for axes, group in zip(grid[1:, -1], block.groups):
        _legend_beside(axes, group.title, group.models)


def is_failed(point):
    return point.status != "ok"


def marker_sizes(points):
    """Of every mesh size, in points: larger for finer meshes."""
    across = sorted({p.across for p in points})
    sizes = np.linspace(_SMALLEST_MARKER, _LARGEST_MARKER, len(across)) if len(across) > 1 else [4]
    return {count: float(size) for count, size in zip(across, sizes)}


def style(model):
    """Keywords of plot: the method's own, and what the variant changes of it."""
    own = line(f"{model.method}:{model.element}" if model.element else model.method)
    for part, looks in _VARIANTS.items():
        own |= looks.get(getattr(model, part), {})
    if own.get("fillstyle", "full") != "full":
        own |= {"markerfacecolor": own["color"], "markerfacecoloralt": "white"}
    return own | {"linewidth": 0.9, "markeredgewidth": 0.7}


@dataclass
class _Scale:
    """Of a column's errors [%], and the heights of the lanes above them by status."""

    low: float
    high: float
    top: float
    lanes: dict

    def height(self, error):
        return max(error, self.low)


def _scale(points, measure, statuses):
    errors = [p.errors[measure.name] for p in [*points, *measure.front] if not is_failed(p)]
    known = [error for error in errors if error is not None and error > 0]
    low, high = (min(known), max(known)) if known else (0.1, 100)
    if measure.bar:
        low = max(low, measure.bar / _MOST_BELOW_BAR)
        high = max(high, low)
        if measure.bar > low / _MOST_TO_BAR:
            low = min(low, measure.bar / 2)
    low = min([low, *measure.errors_told])
    low, high = low / 2, high * 1.5  # below there is the bar's text
    names = [*statuses, *(["no error known"] if None in errors else [])]
    step = (high / low) ** _LANE
    lanes = {name: high * step ** (i + 0.6) for i, name in enumerate(names)}
    return _Scale(low, high, high * step ** (len(names) + 0.1) if names else high, lanes)


def _frame(axes, times, scale, points, measure):
    """Axes with what all rows show: the band, all points in grey, the front's line."""
    axes.set(xscale="log", yscale="log")
    axes.set(xlim=times, ylim=(scale.low, scale.top))
    # Of times two are enough: their labels are beside each other.
    for axis, low, high, fewest in ((axes.xaxis, *times, 2), (axes.yaxis, scale.low, scale.high, 3)):
        axis.set_major_locator(FixedLocator(ticks(low, high, fewest)))
        axis.set_minor_locator(FixedLocator([]))
        axis.set_major_formatter("{x:g}")
    if scale.lanes:
        axes.axhline(scale.high, color=_INK, linewidth=0.5)
    axes.patch.set_visible(False)
    if measure.bar and measure.bar > scale.low:
        low, high = scale.low, measure.bar
        _put_behind(axes, Polygon([(0, low), (1, low), (1, high), (0, high)], **_BAND), axes.get_yaxis_transform())
    shown = [p for p in points if not is_failed(p) and p.errors[measure.name] is not None]
    heights = [scale.height(p.errors[measure.name]) for p in shown]
    grey = {"linestyle": "none", "color": _CONTEXT, "zorder": -1, "rasterized": True}
    _put_behind(axes, Line2D([p.time for p in shown], heights, marker="o", markersize=1.8, **grey), axes.transData)
    lost = [p for p in points if p not in shown]
    heights = [_lane(scale, p) for p in lost]
    _put_behind(axes, Line2D([p.time for p in lost], heights, marker="x", markersize=2.5, **grey), axes.transData)
    if measure.front:
        x = [*(p.time for p in measure.front), times[1]]
        y = [scale.height(error) for error in measure.errors_told]
        axes.step(x, [*y, y[-1]], where="post", zorder=1.5, **FRONT)


def _put_behind(axes, artist, transform):
    """Into the figure, below its axes. What is grey there is pixels, in one image for all
    axes: so many markers in so many panels would be most of the file."""
    artist.set_transform(transform)
    axes.figure.add_artist(artist)
    artist.set_clip_box(axes.bbox)


def ticks(low, high, fewest=3):
    """Between the two: decades, thinned out where there are more than five; further digits
    where there would be fewer than asked for."""
    exponents = range(int(np.floor(np.log10(low))), int(np.ceil(np.log10(high))) + 1)
    found = []
    for digits in ([1], [1, 3], [1, 2, 5], range(1, 10)):
        found = [float(f"{digit}e{exponent}") for exponent in exponents for digit in digits]
        found = [value for value in found if low <= value <= high]
        if len(found) >= fewest:
            break
    return found[:: -(-len(found) // 5)] if digits == [1] else found


def _lane(scale, point):
    return scale.lanes[point.status if is_failed(point) else "no error known"]


def _name_lanes(axes, scale):
    for name, height in scale.lanes.items():
        place = {"xycoords": axes.get_yaxis_transform(), "textcoords": "offset points"}
        kept = {"ha": "right", "va": "center", "fontsize": 5.5, "annotation_clip": False}
        axes.annotate(name.replace("_", " "), (0, height), (-3, 0), color=_INK, **place, **kept)


def _name_bar(axes, measure):
    """In the corner of the fastest and most accurate, which is empty."""
    if not measure.bar:
        return
    text = f"known to {measure.bar:.2g} %"
    axes.annotate(text, (0, 0), (2.5, 2.5), xycoords="axes fraction", textcoords="offset points", fontsize=5.5,
                  color=_INK, zorder=6)


def _draw_model(axes, scale, measure, points, sizes):
    """Its points from the coarsest to the finest mesh, the line broken at failed ones."""
    look = style(points[0].model)
    points = sorted(points, key=lambda p: p.across)
    errors = [None if is_failed(p) else p.errors[measure.name] for p in points]
    heights = [np.nan if error is None else scale.height(error) for error in errors]
    axes.plot([p.time for p in points], heights, **(look | {"marker": ""}), zorder=2)
    for point, height in zip(points, heights):
        if np.isfinite(height):
            _draw_point(axes, point, height, look, sizes)
        else:
            cross = {"marker": "x", "color": look["color"], "markersize": sizes[point.across], "zorder": 4}
            axes.plot([point.time], [_lane(scale, point)], markeredgewidth=0.9, clip_on=False, **cross)


def _draw_point(axes, point, height, look, sizes):
    axes.plot([point.lower, point.upper], [height] * 2, color=look["color"], linewidth=0.8, zorder=2.5)
    marker = {"linestyle": "none", "markersize": sizes[point.across], "zorder": 3, "clip_on": False}
    axes.plot([point.time], [height], **(look | marker))


def _draw_front(axes, scale, measure, sizes):
    heights = [scale.height(p.errors[measure.name]) for p in measure.front]
    for point, height in zip(measure.front, heights):
        _draw_point(axes, point, height, style(point.model), sizes)
    texts = [f"{p.across}" if p.threads == 1 else f"{p.across} ({p.threads})" for p in measure.front]
    places = [_in_points(axes, p.time, height) for p, height in zip(measure.front, heights)]
    for point, height, text, offset in zip(measure.front, heights, texts, text_offsets(places, texts)):
        axes.annotate(text, (point.time, height), offset, textcoords="offset points", fontsize=5.5, zorder=6,
                      ha="center", va="center")


def _in_points(axes, x, y):
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    width, height = _PANEL
    return (width * np.log(x / left) / np.log(right / left), height * np.log(y / bottom) / np.log(top / bottom))


def text_offsets(places, texts):
    """For each place [points] the nearest offset of its text's middle at which the text
    covers neither a place nor an earlier text and stays right of the axis; above and right
    first, where no front is."""
    angles = np.radians([45, 90, 20, -135, -90, 160, -20, -160])
    boxes, offsets = [(x, y, 3, 3) for x, y in places], []
    for (x, y), text in zip(places, texts):
        half = (2 * len(text) + 1, 3)
        tried = [(r * np.cos(a), r * np.sin(a)) for r in (7, 10, 13, 17, 21) for a in angles]
        tried = [o for o in tried if x + o[0] > half[0]]
        free = (o for o in tried if not any(_overlap((x + o[0], y + o[1], *half), box) for box in boxes))
        offset = next(free, tried[0])
        boxes.append((x + offset[0], y + offset[1], *half))
        offsets.append(offset)
    return offsets


def _overlap(a, b):
    """Of boxes by middle and half widths."""
    return abs(a[0] - b[0]) < a[2] + b[2] and abs(a[1] - b[1]) < a[3] + b[3]


def _legend_beside(axes, title, models, **changes):
    axes.set_axis_off()
    handles = [Line2D([], [], **(style(model) | {"markersize": 4.5} | changes)) for model in models]
    small = {"fontsize": 5.8, "labelspacing": 0.35, "handlelength": 2.4, "borderaxespad": 0}
    found = axes.legend(handles, [model.name for model in models], title=title, loc="upper left", bbox_to_anchor=(-0.12, 1.0), **small)
    found.set_title(title, {"size": 6.3, "weight": "bold"})
    found._legend_box.align = "left"


def _across(count):
    return "1 cell across" if count == 1 else f"{count} cells across"


def _common_legend(figure, sizes, has_failed):
    """Of what looks the same for all models."""
    handles = [
        Line2D([], [], ls="none", marker="o", color="#777777", markersize=size, label=_across(count))
        for count, size in sizes.items()
    ]
    handles.append(Line2D([], [], **FRONT, label="Pareto front, all thread counts"))
    handles.append(Patch(facecolor=_BAND["facecolor"], label="below the bound of the converged solution"))
    handles.append(Line2D([], [], color="#777777", linewidth=0.8, label="quartiles of the times"))
    if has_failed:
        handles.append(Line2D([], [], ls="none", marker="x", color="#777777", label="failed, at its time"))
    figure.legend(handles=handles, ncols=4, loc="upper center", bbox_to_anchor=(0.5, 0))
