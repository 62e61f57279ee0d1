"""Springs on any cells, convergence, subdivision: from tables of the same names."""

import numpy as np
from content import Figure, Section, paragraph
from figures import cells as cell_figures
from figures import curves
from sections.documents import table_blocks


def any_cells(study):
    document = study.tables.get("elements")
    if document is None:
        return None
    rows = document["rows"]
    meshes = list(dict.fromkeys(row["mesh"] for row in rows))
    figures = []
    for test in ("compression", "shearing", "torsion"):
        panels = []
        for nu in (0.25, 0.499):
            methods = {}
            for row in rows:
                value = row[f"off_truth_{test}"]
                if row["nu"] == nu and value is not None:
                    errors = methods.setdefault(row["method"], np.full(len(meshes), np.nan))
                    errors[meshes.index(row["mesh"])] = value
            panels.append((f"nu = {nu:g}", methods))
        caption = (
            f"{test.capitalize()}: force off what triquadratic finite elements converge to, by "
            "mesh. Right of zero is too stiff; the axis is linear within ±5 %."
        )
        arguments = (meshes, panels, "force off the converged value [%]")
        figures.append(Figure(f"cells_{test}", caption, cell_figures.draw, arguments))
    section = Section("elements", "Any cells: cubes, mixed meshes, tetrahedra")
    section.blocks.append(paragraph("{}.", document["title"]))
    section.blocks += [*figures, *table_blocks(document)]
    return section


def convergence(study):
    document = study.tables.get("convergence")
    if document is None:
        return None
    rows = [row for row in document["rows"] if row["force_error"] is not None]
    panels = []
    for nu in sorted({row["nu"] for row in rows}):
        lines = []
        chosen = [row for row in rows if row["nu"] == nu and row["cell_type"] in ("hexahedron", "mixed")]
        for name in dict.fromkeys((row["method"], row["cell_type"]) for row in chosen):
            of_name = [row for row in chosen if (row["method"], row["cell_type"]) == name]
            x = np.array([1000 * row["h"] for row in of_name])
            y = np.abs([row["force_error"] for row in of_name])
            label = name[0] if name[1] == "hexahedron" else f"{name[0]}, {name[1]}"
            lines.append(curves.Curve(label, x, y))
        panel = curves.Panel(f"nu = {nu:g}", "cell edge h [mm]", "|force error| [%]", lines, True, True)
        panels.append(panel)
    section = Section("convergence", "Convergence in the mesh")
    caption = (
        f"{document['title']}: error of the force against the edge of a cell, on cubes and mixed "
        "cells. All types of cells are in the table."
    )
    section.blocks.append(Figure("convergence", caption, curves.draw, (panels[:3],)))
    section.blocks += table_blocks(document)
    return section


def subdivision(study):
    document = study.tables.get("subdivision")
    if document is None:
        return None
    section = Section("subdivision", "Cells against what they can be cut into")
    section.blocks += [paragraph("{}.", document["title"]), *table_blocks(document, limit=60)]
    return section
