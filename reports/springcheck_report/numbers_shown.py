"""Numbers as the page shows them."""

import math
from html import escape


def significant(value, digits=4):
    """A value to so many significant digits, in plain notation where that is readable:
    2.86131 -> "2.861", 0.0001234 -> "1.234e-04", 58368.2 -> "58370"."""
    if not math.isfinite(value):
        return "–"
    if value == 0:
        return "0"
    exponent = math.floor(math.log10(abs(float(f"{value:.{digits - 1}e}"))))  # 9.9996 is 10.00
    if not -4 <= exponent < 7:
        return f"{value:.{digits - 1}e}"
    return f"{round(value, digits - 1 - exponent):.{max(0, digits - 1 - exponent)}f}"


def with_bar(value, bar):
    """Value and error bar, both to the place of the bar's first digit, or its second where
    the first is 1: (3.0981, .0103) -> ("3.098", "0.010"); (1266.2, 3.2) -> ("1266", "3")."""
    if not bar > 0:
        return significant(value), "0"
    place = -math.floor(math.log10(bar))
    if bar * 10**place < 2:
        place += 1
    decimals = max(0, place)
    return f"{round(value, place):.{decimals}f}", f"{round(bar, place):.{decimals}f}"


def formatted(value, form):
    """By a table's own format; no minus before a zero."""
    text = form.format(value)
    return form.format(0.0) if not any(c in "123456789" for c in text) else text


def data(value, text, key=None, measure=None):
    """HTML of a number that says where it comes from: <data> with the full value, and the
    case and measure of the result file that it is."""
    source = ""
    if key is not None:
        source = f' data-case="{escape(key)}" data-measure="{escape(measure)}"'
    return f'<data value="{value!r}"{source}>{escape(text)}</data>'


def revision_text(revisions):
    """Of revisions of the numerics with commas between: "revision 0123456789ab, an unknown one"."""
    names = revisions.split(",")
    return ", ".join("an unknown one" if name == "unknown" else f"revision {name}" for name in names)
