"""Theory of stability: integrators, the four springs that buckle, the infinite lattice."""

import numpy as np
from content import Figure, Section, paragraph
from figures import four_springs as four_springs_figure
from figures import regions as region_figures
from sections.documents import titled_table


def stability_theory(study):
    """From the tables regions, four-springs and lattice-stability, those there are."""
    lattice = titled_table(study.tables.get("lattice-stability"))
    blocks = [*_regions(study), *_four_springs(study), *lattice]
    if not blocks:
        return None
    section = Section("stability-theory", "Theory of stability")
    section.blocks += [paragraph("What small systems tell before any body is simulated."), *blocks]
    return section


def _column(rows, key):
    return np.array([row[key] for row in rows], dtype=float)


def _regions(study):
    document = study.tables.get("regions")
    if document is None:
        return []
    borders = [_border(document, figure) for figure in ("2.2 left", "2.2 right", "2.3")]
    caption = (
        "Stability regions of the integrators (thesis, figures 2.2 and 2.3): shaded, where steps of "
        "x' = Γ x, or of the oscillator with Γ dt = ω dt (−ζ ± i√(1 − ζ²)), stay bounded. Dots: where "
        "the spectral radius of a step made by this program passes 1. Of the third region's circle, "
        "of radius 2√2 about 2, only the part left of the imaginary axis is stable."
    )
    plane = Figure("regions_plane", caption, region_figures.draw_plane, (borders,))
    rows = [row for row in document["rows"] if row["figure"] == "omega dt, zeta"]
    names = list(dict.fromkeys(row["integrator"] for row in rows))
    found = []
    for name in names:
        own = [row for row in rows if row["integrator"] == name]
        found.append((name, _column(own, "zeta"), _column(own, "border")))
    own = [row for row in rows if row["integrator"] == names[0]]
    caption = (
        "The same of the damped oscillator in the plane of damping and step: both integrators of "
        "springs, with the dashpots of the step before, have one border, 2 without damping. Damping "
        "shortens the step."
    )
    arguments = _column(own, "zeta"), _column(own, "on_paper"), found
    over_damping = Figure("regions_damping", caption, region_figures.draw_over_damping, arguments)
    title, *blocks = titled_table(document)
    return [title, plane, over_damping, *blocks]


def _border(document, figure):
    rows = [row for row in document["rows"] if row["figure"] == figure]
    return region_figures.Border(
        f"{rows[0]['integrator']} ({figure})",
        np.arcsin(_column(rows, "zeta")),
        _column(rows, "border"),
        _column(rows, "on_paper"),
        rows[0]["stable"] == "inside",
    )


def _four_springs(study):
    document = study.tables.get("four-springs")
    if document is None:
        return []
    rows = sorted((row for row in document["rows"] if row["part"] == "held"), key=lambda row: row["zeta"])
    held = {
        key: _column(rows, key)
        for key in ("zeta", "centre", "centre_on_paper", "force", "force_on_paper")
    }
    loop = [
        (row["part"] == "load grows", row["zeta"], row["force"])
        for row in document["rows"]
        if row["part"] != "held"
    ]
    caption = (
        "Four equal springs about a node C (thesis, figure 3.2). Left: where C rests while A and B are "
        "held; between the dotted lines it goes aside, to either side. Right: the force on A, and "
        "arrows from rest to rest under a load that grows, goes back and grows again: beyond "
        "F = ±k l/2 it jumps, and comes back by another way."
    )
    figure = Figure("four_springs", caption, four_springs_figure.draw, (held, loop))
    title, *blocks = titled_table(document)
    return [title, figure, *blocks]
