"""How a method looks, the same in every figure, and how figures are set."""

import zlib

import matplotlib
import methods

# For methods that are not known: others' results.
_OTHERS = ["#AA3377", "#228833", "#BB5566", "#004488", "#997700"]

# Statuses by what they mean for a user: usable, suspect, none. No method's colours.
STATUS_COLOURS = {
    "ok": "#C6DFC6",
    "wrinkled": "#F4C430",
    "indefinite": "#C9A0DC",
    "inverted": "#7B3294",
    "no_equilibrium": "#C51B3A",
    "not_converged": "#5B1A18",
    "diverged": "#2B2B6B",
    "refused": "#DDDDDD",
}

# Rings around values that are not ok, told by their shape: methods have all the colours.
RINGS = {"wrinkled": "o", "indefinite": "s", "inverted": "D"}
OTHER_RING = "h"

# Kinds of failure in maps, by the names of comparisons/stability/failure.hpp: colour,
# hatch, and the ink of a letter on it. Okabe and Ito's palette; light to dark as well, for
# print in grey.
FAILURE_STYLES = {
    "none": ("#F3F6F3", "", "#687268"),
    "locking": ("#F0E442", "--", "black"),
    "wrinkling": ("#E69F00", "//", "black"),
    "hourglassing": ("#D55E00", "**", "black"),
    "loss of definiteness": ("#56B4E9", "\\\\", "black"),
    "limit point": ("#B2476E", "xx", "white"),
    "inversion": ("#1F4E9E", "||", "white"),
    "blow-up": ("#1A1A1A", "++", "white"),
    "solver failure": ("#939393", "oo", "black"),
    "not covered": ("#CCCCCC", "..", "black"),
}
NOT_COMPUTED = ("white", "....", "black")

# Curves that are no methods: theory, settings, parts of errors.
NEUTRAL = ["#222222", "#777777", "#AAAAAA"]


def shades(count):
    """Colours along a scale, for values of a setting."""
    return [matplotlib.colormaps["viridis"](0.9 * i / max(count - 1, 1)) for i in range(count)]


TWO_COLUMNS = 7.2  # inches, of a journal's page


def _base(name):
    """The method alone, of a name in tables such as fem-stvk:q1-sri."""
    for separator in (":", ",", " ("):
        name = name.split(separator)[0]
    return name


def colour(name):
    """Of a method by its name in tables; labels of measured results get one of their own."""
    base = _base(name)
    known = methods.look(base)
    return known[0] if known else _OTHERS[zlib.crc32(base.encode()) % len(_OTHERS)]


def line(name):
    """Keywords of matplotlib's plot for a method: finite elements are dashed, by element,
    hollow where they lock and half full where they are averaged around nodes."""
    base = _base(name)
    element = name.split(":")[1].split(",")[0].split(" ")[0] if ":" in name else ""
    dashes = {"q1": ":", "q1-nodal": (0, (4, 1, 1, 1, 1, 1)), "q2": "-."}.get(element, "--")
    mark = (methods.look(base) or (None, "*"))[1]
    is_dashed = methods.family(base) == "finite elements"
    return {
        "fillstyle": "bottom" if element == "q1-nodal" else "full",
        "markerfacecoloralt": "white",
        "markerfacecolor": "white" if methods.locks(base, element) else colour(name),
        "color": colour(name),
        "marker": "*" if ", " in name else mark,  # variants, others' methods
        "linestyle": dashes if is_dashed else "-",
        "markersize": 3.5,
        "linewidth": 1.1,
    }


def legend_below(figure, columns=5, further=()):
    """One legend for all panels below the figure: every label once, then further handles
    with labels."""
    entries = {}
    for axes in figure.axes:
        for handle, label in zip(*axes.get_legend_handles_labels()):
            entries.setdefault(label, handle)
    entries.update({label: handle for handle, label in further})
    if entries:
        place = {"loc": "upper center", "bbox_to_anchor": (0.5, 0)}
        figure.legend(entries.values(), entries, ncols=min(columns, len(entries)), **place)


def plain_numbers(axis):
    """Ticks of a logarithmic axis as 0.01, 10; powers would need matplotlib's mathtext,
    which is off as users' labels may hold dollars."""
    axis.set_major_formatter("{x:g}")
    axis.set_minor_formatter("")


def set_defaults():
    """Typography of all figures, and files that depend on nothing but what they show."""
    matplotlib.use("agg")
    matplotlib.rcParams.update(
        {
            "font.family": "DejaVu Sans",
            "font.size": 7.5,
            "axes.titlesize": 8,
            "axes.labelsize": 7.5,
            "legend.fontsize": 6.5,
            "legend.frameon": False,
            "axes.spines.top": False,
            "axes.spines.right": False,
            "axes.grid": True,
            "grid.color": "#E4E4E4",
            "grid.linewidth": 0.5,
            "axes.axisbelow": True,
            "axes.linewidth": 0.6,
            "xtick.major.width": 0.6,
            "ytick.major.width": 0.6,
            "figure.dpi": 100,
            "text.parse_math": False,  # users' labels may hold dollars
            "legend.handlelength": 2.8,
            "svg.hashsalt": "springcheck",
            "svg.fonttype": "path",
            "pdf.fonttype": 42,
            "figure.constrained_layout.use": True,
        }
    )
