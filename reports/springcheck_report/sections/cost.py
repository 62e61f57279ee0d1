"""Times of single runs: error against time with the Pareto front, time against cells."""

import measures
import numpy as np
from case_words import is_variant
from content import Figure, Section, paragraph
from figures import cost as cost_figures


def cost(study):
    """Charts tell error against time better, by repeated runs that had the machine to
    themselves: beside them there is time against cells alone."""
    errors, times = None if study.charts else _errors(study), _times(study)
    if errors is None and times is None:
        return None
    section = Section("cost", "Time against cells" if study.charts else "Speed against accuracy")
    processors = sorted(set(study.results.provenance.get("cpu", ["an unknown processor"])))
    section.blocks.append(
        paragraph(
            "Times are those of single solutions on {}, several cases side by side, in {} "
            "session(s): good for orders of magnitude, not for rankings within a factor of two.",
            ", ".join(processors),
            str(len(study.results.provenance)),
        )
    )
    captions = {
        "Error against time: along each curve cells halve their edges, from 25 mm on. The wide line is the Pareto "
        "front, beyond which no method here is both faster and better.": errors,
        "Time against cells: static solutions in compression by 5 %, nu = 0.25.": times,
    }
    caption = " ".join(text for text, panel in captions.items() if panel)
    section.blocks.append(Figure("cost", caption, cost_figures.draw, (errors, times)))
    return section


def _errors(study):
    """From the table of convergence: deviation of the points, at the nu nearest to 0.25, on
    cubes and tetrahedra. The force's error changes sign on the way, and looks good there."""
    document = study.tables.get("convergence")
    if document is None:
        return None
    rows = [row for row in document["rows"] if row["deviation"] is not None]
    rows = [row for row in rows if row["case"] in study.cases.index]
    if not rows:
        return None
    nu = min({row["nu"] for row in rows}, key=lambda value: abs(value - 0.25))
    methods = {}
    for row in rows:
        if row["nu"] != nu or row["cell_type"] not in ("hexahedron", "free-tetrahedron"):
            continue
        name = row["method"]
        if row["cell_type"] != "hexahedron":
            name += f", {row['cell_type']}"
        seconds, errors = methods.setdefault(name, ([], []))
        seconds.append(study.cases.loc[row["case"], "solve_wall_s"])
        errors.append(row["deviation"])
    methods = {name: (np.array(seconds), np.array(errors)) for name, (seconds, errors) in methods.items()}
    return (f"{measures.heading('deviation_l2_relative')}, shearing, nu = {nu:g}", methods)


def _times(study):
    """Per method the median time of static solutions on blocks of hexahedra, in compression
    by 5 % at nu = 0.25, by cells."""
    cases = study.cases[
        (study.cases.status == "ok")
        & (study.cases.test == "compression")
        & np.isclose(study.cases.deformation, 0.05)
        & np.isclose(study.cases.nu, 0.25)
        & (study.cases["cell-type"] == "hexahedron")
        & (study.cases.solver == "static")
        & (study.cases.kind != "measured")
    ]
    cells = cases["cells.x"] * cases["cells.y"] * cases["cells.z"]
    methods = {}
    for name, group in cases.assign(count=cells).groupby("name"):
        medians = group.groupby("count").solve_wall_s.median()
        if len(medians) >= 2 and medians.min() > 0 and not is_variant(name):
            methods[name] = (medians.index.to_numpy(), medians.to_numpy())
    return methods or None
