"""Words and numbers that the answers share."""

import measures
import methods
from markupsafe import Markup
from numbers_shown import significant

SIZE = 3.6, 2.05  # inches of a picture: half a page

def gone_through(test, load):
    """"Pressed by 5 %"."""
    words = measures.passive(test)
    return f"{words[0].upper()}{words[1:]} {load}"


def case_number(value, key, digits=2):
    """A number that a case gave, with its full value."""
    value = float(value)
    return Markup('<data value="{!r}" data-case="{}">{}</data>').format(value, key, significant(value, digits))


def bold(name):
    return Markup("<b>{}</b>").format(name)


def foremost_springs(names):
    """Those of the names that people want to see first, in that order."""
    return [name for name in methods.foremost("springs") if name in set(names)]


def first_and_nearest(distances):
    """Of springs by their distance from elements: the thesis's, or the first, and the nearest."""
    thesis = methods.of_thesis()
    first = thesis if thesis in distances else next(iter(distances))
    return list(dict.fromkeys([first, min(distances, key=distances.get)]))
