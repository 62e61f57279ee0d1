"""Error against time of every model: work and precision."""

from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from method_style import TWO_COLUMNS, line

_FRONT = {"color": "#CC3311", "linewidth": 3, "alpha": 0.25, "solid_joinstyle": "miter"}
_BAND = {"facecolor": "#E9E2CF", "edgecolor": "none", "zorder": 0}
_CONTEXT = "#C9C9C9"
_INK = "#444444"
_ROW_HEIGHT = 1.42  # inches
_PANEL = 122, 88  # points of a panel's width and height, near enough to place texts by
_LANE = 0.1  # height of a status's lane, of the errors' own
_MOST_BELOW_BAR = 10  # an error that is so much smaller than the bar says nothing more
_MOST_TO_BAR = 30  # a bar that is so much smaller than all errors is told by its number
_SMALLEST_MARKER, _LARGEST_MARKER = 2.6, 6.2
# What tells a variant from the method's usual form.
_VARIANTS = {
    "tetrahedra": {"fillstyle": "left"},
    "prisms": {"fillstyle": "right"},
    "float": {"fillstyle": "bottom"},
    "direct": {"marker": "*"},
    "multigrid": {"marker": "*", "markerfacecolor": "white"},
}


@dataclass
class Point:
    """One model on one mesh. time, lower and upper quartile in the figure's unit; errors:
    by measure [%], None where unknown."""

    model: str
    across: int
    threads: int
    status: str
    time: float
    lower: float
    upper: float
    errors: dict


@dataclass
class Measure:
    """A column: front: its points, from the fastest to the most accurate; bar: what the
    truth itself may be off [%], None where unknown."""

    name: str
    title: str
    front: list
    bar: float | None


@dataclass
class Group:
    """A row: models that are told apart in it."""

    title: str
    models: list


def draw(time_label, points, measures, groups):
    """Columns: measures. Rows: the front, then groups before all others in grey."""
    height = _ROW_HEIGHT * (1 + len(groups)) + 0.75
    figure = Figure((TWO_COLUMNS, height))
    widths = [1] * len(measures) + [0.68]
    grid = figure.subplots(1 + len(groups), len(widths), squeeze=False, width_ratios=widths)
    sizes = marker_sizes(points)
    statuses = list(dict.fromkeys(p.status for p in points if is_failed(p)))
    for column, measure in enumerate(measures):
        scale = _scale(points, measure, statuses)
        for row in range(1 + len(groups)):
            axes = grid[row, column]
            _frame(axes, scale, points, measure)
            if column == 0:
                axes.set_ylabel("error [%]")
                _name_lanes(axes, scale)
            if row == 0:
                axes.set_title(measure.title)
            if row == len(groups):
                axes.set_xlabel(time_label)
            else:
                axes.tick_params(axis="x", labelbottom=False)
        _draw_front(grid[0, column], scale, measure, sizes)
        _name_bar(grid[0, column], scale, measure)
        for row, group in enumerate(groups, 1):
            for model in group.models:
                own = [p for p in points if p.model == model]
                _draw_model(grid[row, column], scale, measure, own, sizes)
    on_front = list(dict.fromkeys(p.model for m in measures for p in m.front))
    _legend_beside(grid[0, -1], "Pareto front,\nand all models in grey", on_front)
    for row, group in enumerate(groups, 1):
        _legend_beside(grid[row, -1], group.title, group.models)
    _common_legend(figure, sizes, statuses)
    return figure


def is_failed(point):
    return point.status != "ok"


def marker_sizes(points):
    """Of every mesh size, in points: larger for finer meshes."""
    across = sorted({p.across for p in points})
    sizes = np.linspace(_SMALLEST_MARKER, _LARGEST_MARKER, len(across)) if len(across) > 1 else [4]
    return {count: float(size) for count, size in zip(across, sizes)}


def style(model):
    """Keywords of plot: the method's own, and what the variant changes of it."""
    method, *variants = model.replace(" on ", ", ").split(", ")
    own = line(method)
    if ":q2" in method:
        own["fillstyle"] = "top"
    for variant in variants:
        own |= _VARIANTS.get(variant, {} if variant == "double" else {"marker": "*"})
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
    low, high = low / 1.5, high * 1.5
    names = [*statuses, *(["no error known"] if None in errors else [])]
    step = (high / low) ** _LANE
    lanes = {name: high * step ** (i + 0.6) for i, name in enumerate(names)}
    return _Scale(low, high, high * step ** (len(names) + 0.1) if names else high, lanes)


def _frame(axes, scale, points, measure):
    """Axes with what all rows show: the band, all points in grey, the front's line."""
    axes.set(xscale="log", yscale="log")
    times = [t for p in [*points, *measure.front] for t in (p.lower, p.upper)]
    first, last = min(times) / 1.5, max(times) * 1.5
    axes.set(xlim=(first, last), ylim=(scale.low, scale.top))
    for axis, low, high in ((axes.xaxis, first, last), (axes.yaxis, scale.low, scale.high)):
        axis.set_major_locator(_fixed(ticks(low, high)))
        axis.set_minor_locator(_fixed([]))
        axis.set_major_formatter("{x:g}")
    if scale.lanes:
        axes.axhline(scale.high, color=_INK, linewidth=0.5)
    if measure.bar and measure.bar > scale.low:
        axes.axhspan(scale.low, measure.bar, **_BAND)
    grey = {"ls": "none", "color": _CONTEXT, "zorder": 1}
    shown = [p for p in points if not is_failed(p) and p.errors[measure.name] is not None]
    heights = [scale.height(p.errors[measure.name]) for p in shown]
    axes.plot([p.time for p in shown], heights, marker="o", markersize=1.8, **grey)
    lost = [p for p in points if p not in shown]
    axes.plot([p.time for p in lost], [_lane(scale, p) for p in lost], marker="x", markersize=2.5, **grey)
    if measure.front:
        x = [*(p.time for p in measure.front), last]
        y = [max(scale.height(p.errors[measure.name]), measure.bar or 0) for p in measure.front]
        axes.step(x, [*y, y[-1]], where="post", zorder=1.5, **_FRONT)


def _fixed(places):
    from matplotlib.ticker import FixedLocator

    return FixedLocator(places)


def ticks(low, high):
    """Between the two: decades, thinned out where there are many; of less than two decades
    also 2 and 5, or every digit."""
    exponents = range(int(np.floor(np.log10(low))), int(np.ceil(np.log10(high))) + 1)

    def inside(digits):
        found = [float(f"{digit}e{exponent}") for exponent in exponents for digit in digits]
        return [value for value in found if low <= value <= high]

    decades = inside([1])
    if len(decades) > 5:
        return decades[:: -(-len(decades) // 5)]
    if len(decades) > 2:
        return decades
    few = inside([1, 2, 5])
    return few if len(few) > 1 else inside(range(1, 10))


def _lane(scale, point):
    return scale.lanes[point.status if is_failed(point) else "no error known"]


def _name_lanes(axes, scale):
    for name, height in scale.lanes.items():
        place = {"xycoords": axes.get_yaxis_transform(), "textcoords": "offset points"}
        kept = {"ha": "right", "va": "center", "fontsize": 5.5, "annotation_clip": False}
        axes.annotate(name.replace("_", " "), (0, height), (-3, 0), color=_INK, **place, **kept)


def _name_bar(axes, scale, measure):
    """In the corner of the fastest and most accurate, which is empty."""
    if not measure.bar:
        return
    text = f"truth unsure by {measure.bar:.2g} %"
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
    bar = {"fmt": "none", "ecolor": look["color"], "elinewidth": 0.8, "zorder": 2.5}
    axes.errorbar([point.time], [height], xerr=_quartile_bar(point), **bar)
    marker = {"linestyle": "none", "markersize": sizes[point.across], "zorder": 3, "clip_on": False}
    axes.plot([point.time], [height], **(look | marker))


def _quartile_bar(point):
    return [[max(point.time - point.lower, 0)], [max(point.upper - point.time, 0)]]


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
    covers neither a place nor an earlier text; above and right first, where no front is."""
    angles = np.radians([45, 90, 20, -135, -90, 160, -20, -160])
    boxes, offsets = [(x, y, 3, 3) for x, y in places], []
    for (x, y), text in zip(places, texts):
        half = (1.8 * len(text), 3)
        tried = [(r * np.cos(a), r * np.sin(a)) for r in (7, 10, 13, 17, 21) for a in angles]
        free = (o for o in tried if not any(_overlap((x + o[0], y + o[1], *half), box) for box in boxes))
        offset = next(free, tried[0])
        boxes.append((x + offset[0], y + offset[1], *half))
        offsets.append(offset)
    return offsets


def _overlap(a, b):
    """Of boxes by middle and half widths."""
    return abs(a[0] - b[0]) < a[2] + b[2] and abs(a[1] - b[1]) < a[3] + b[3]


def _legend_beside(axes, title, models):
    axes.set_axis_off()
    handles = [Line2D([], [], **(style(model) | {"markersize": 4.5})) for model in models]
    small = {"fontsize": 5.8, "labelspacing": 0.35, "handlelength": 2.4, "borderaxespad": 0}
    found = axes.legend(handles, models, title=title, loc="upper left", bbox_to_anchor=(-0.12, 1.0), **small)
    found.set_title(title, {"size": 6.3, "weight": "bold"})
    found._legend_box.align = "left"


def _common_legend(figure, sizes, statuses):
    """Of what looks the same for all models."""
    handles = [
        Line2D([], [], ls="none", marker="o", color="#777777", markersize=size, label=f"{count} cells across")
        for count, size in sizes.items()
    ]
    handles.append(Line2D([], [], **_FRONT, label="Pareto front, all thread counts"))
    handles.append(Patch(facecolor=_BAND["facecolor"], label="below what the truth may be off"))
    handles.append(Line2D([], [], color="#777777", linewidth=0.8, label="quartiles of the times"))
    if statuses:
        handles.append(Line2D([], [], ls="none", marker="x", color="#777777", label="failed, at its time"))
    figure.legend(handles=handles, ncols=4, loc="upper center", bbox_to_anchor=(0.5, 0))
