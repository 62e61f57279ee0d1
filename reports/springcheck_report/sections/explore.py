"""The explorer: every case, along any setting."""

from content import Explorer, Section, paragraph
from explorer import explorer_data


def explore(study):
    section = Section("explore", "Explore")
    section.blocks += [
        paragraph(
            "Every case of the file: choose a test, what runs along the axis and which measures stand side by "
            "side. What is held fixed can be any of its values, or all of them. Marks with a ring are of cases that "
            "are not ok, crosses at the foot of those that failed without a value. The choice stands in the page's address, "
            "which can be sent to others with the page."
        ),
        Explorer(explorer_data(study)),
    ]
    return section
