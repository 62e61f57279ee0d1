"""Living tissue: stress of the bi-power law, of springs that remember, and of the thesis's."""

import numpy as np
from content import Figure, Section, paragraph
from figures import curves
from markupsafe import Markup
from method_style import NEUTRAL, shades
from sections.documents import table_blocks

_MOST_ROWS = 30


def tissue(study):
    """From the tables tissue, tissue-rates, tissue-relaxation, tissue-oscillation and
    tissue-torsion."""
    drawn = {
        "tissue": _shear,
        "tissue-rates": _rates,
        "tissue-relaxation": _relaxation,
        "tissue-oscillation": _moduli,
        "tissue-torsion": _torque,
    }
    blocks = []
    for name, draw in drawn.items():
        document = study.tables.get(name)
        if document is None:
            continue
        title = Markup("<h3>{}</h3>").format(document["title"])
        blocks += [title, draw(document), *table_blocks(document, _MOST_ROWS)]
    if not blocks:
        return None
    section = Section("tissue", "Living tissue")
    section.blocks.append(
        paragraph(
            "Liver, kidney and spleen after the bi-power law of Golec 2018, chapter 4. mss-tissue has "
            "its memory in a few Maxwell branches that are fitted to the law, with nothing set by "
            "hand; Eq. 4.4 is the thesis's own spring force, with limits fitted by hand."
        )
    )
    section.blocks += blocks
    return section


def _organs(document):
    return list(dict.fromkeys(row["organ"] for row in document["rows"]))


def _values(rows, key):
    """NaN where there is no number."""
    return np.array([np.nan if row[key] is None else row[key] for row in rows], dtype=float)


def _line(colour, **more):
    return {"color": colour, "linewidth": 1.2, **more}


def _points(colour, marker="o"):
    return {"color": colour, "linestyle": "none", "marker": marker, "markersize": 3.8}


def _law_and_springs(rows, along, law, springs, colour, suffix=""):
    x = _values(rows, along)
    return [
        curves.Curve(f"law{suffix}", x, _values(rows, law), style=_line(colour)),
        curves.Curve(f"mss-tissue{suffix}", x, _values(rows, springs), style=_points(colour)),
    ]


def _shear(document):
    """Figures 4.4 to 4.8."""
    panels = []
    for organ in _organs(document):
        rows = [row for row in document["rows"] if row["organ"] == organ]
        rates = sorted({row["rate"] for row in rows})
        own = []
        for rate, colour in zip(rates, shades(len(rates) + 1)):  # the last is pale
            of_rate = [row for row in rows if row["rate"] == rate]
            own += _law_and_springs(of_rate, "strain", "law", "springs", colour, f", {rate:g} 1/s")
        first = [row for row in rows if row["rate"] == rates[0]]  # Eq. 4.4 knows no rate
        strains = _values(first, "strain")
        printed = _line(NEUTRAL[0], linestyle="--")
        repaired = _line(NEUTRAL[1], linestyle=":")
        own.append(curves.Curve("Eq. 4.4", strains, _values(first, "thesis"), style=printed))
        own.append(curves.Curve("Eq. 4.4, relative", strains, _values(first, "repaired"), style=repaired))
        panels.append(curves.Panel(organ, "shear strain", "stress [Pa]", own, log_x=True, log_y=True))
    caption = (
        "Stress against strain in simple shear at constant rate. Eq. 4.4 is the same at every rate; "
        "relative, its elongations count over the rest length."
    )
    return Figure("tissue_shear", caption, curves.draw, (panels,))


def _rates(document):
    """In the range of the fit and beyond, on both sides."""
    panels = []
    for organ in _organs(document):
        rows = [row for row in document["rows"] if row["organ"] == organ]
        strains = sorted({row["strain"] for row in rows})
        own = []
        for strain, colour in zip(strains, shades(len(strains) + 1)):
            of_strain = [row for row in rows if row["strain"] == strain]
            within = [row for row in of_strain if row["in_range"] == "yes"]
            beyond = [row for row in of_strain if row["in_range"] == "no"]
            own += _law_and_springs(of_strain, "rate", "law", "branches", colour, f", {strain:g}")[:1]
            for rows_of, face in ((within, colour), (beyond, "white")):
                style = {**_points(colour), "markerfacecolor": face}
                name = f"mss-tissue, {strain:g}" + ("" if rows_of is within else ", extrapolated")
                values = _values(rows_of, "springs")
                own.append(curves.Curve(name, _values(rows_of, "rate"), values, style=style))
        panels.append(curves.Panel(organ, "rate [1/s]", "stress [Pa]", own, log_x=True, log_y=True))
    caption = (
        "Stress at the end of simple shears to 0.1, 0.3 and 1 against their rate. Hollow: outside the "
        "range of rates to which the branches were fitted."
    )
    return Figure("tissue_rates", caption, curves.draw, (panels,))


def _relaxation(document):
    """Held strains alone: the others are few numbers of any sign."""
    panels = []
    for organ in _organs(document):
        rows = [row for row in document["rows"] if (row["organ"], row["then"]) == (organ, "held")]
        own = _law_and_springs(rows, "time", "law", "springs", NEUTRAL[0])
        panels.append(
            curves.Panel(organ, "time since the ramp [s]", "stress [Pa]", own, log_x=True, log_y=True)
        )
    caption = "Stress while a shear of 100 % is held."
    return Figure("tissue_relaxation", caption, curves.draw, (panels,))


def _moduli(document):
    panels = []
    storage, loss = shades(3)[:2]
    for organ in _organs(document):
        rows = [row for row in document["rows"] if row["organ"] == organ]
        own = [
            *_law_and_springs(rows, "angular_frequency", "storage", "storage_springs", storage, ", G'"),
            *_law_and_springs(rows, "angular_frequency", "loss", "loss_springs", loss, ", G''"),
        ]
        panels.append(
            curves.Panel(
                organ, "angular frequency [rad/s]", "modulus [Pa]", own, log_x=True, log_y=True
            )
        )
    caption = "Storage and loss modulus against frequency, of a shear of 0.1 %."
    return Figure("tissue_moduli", caption, curves.draw, (panels,))


def _torque(document):
    """Deviation of the torque by mesh."""
    meshes = [
        column["key"].removesuffix("_off") for column in document["columns"] if column["key"].endswith("_off")
    ]
    panels = []
    for organ in _organs(document):
        rows = [row for row in document["rows"] if row["organ"] == organ]
        strains = _values(rows, "rim_strain")
        own = []
        for mesh, colour in zip(meshes, shades(len(meshes) + 1)):
            name = f"{mesh.removeprefix('springs_')} cells across"
            style = {**_points(colour), "linestyle": "-", "linewidth": 1.1}
            own.append(curves.Curve(name, strains, _values(rows, f"{mesh}_off"), style=style))
        panels.append(curves.Panel(organ, "strain at the rim", "torque off the law [%]", own))
    caption = "Torque on a disc between turning plates, off that of the law, on three meshes."
    return Figure("tissue_torque", caption, curves.draw, (panels,))
