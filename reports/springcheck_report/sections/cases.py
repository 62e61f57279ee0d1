"""Every case, where it comes from, and the files for ParaView."""

import pandas as pd
from content import Section, paragraph, table
from markupsafe import Markup
from paraview import vtu_name
from sections.documents import table_blocks

_MOST_ROWS = 2000


def empty_file(study):
    """What to run, for a file without cases."""
    section = Section("empty", "No cases yet")
    section.blocks += [
        paragraph("{} holds no case. To fill one and look at it:", study.results.path.name),
        Markup(
            "<pre>springcheck run compression --out results.h5\n"
            "springcheck sweep nu --out results.h5\n"
            "springcheck report results.h5 --out report</pre>"
        ),
        paragraph(
            "<code>springcheck reproduce --out results</code> computes all the tables of the "
            "thesis and makes the full page."
        ),
    ]
    return section


def all_cases(study):
    """The table of all cases that the C++ program wrote."""
    document = study.tables.get("cases")
    if document is None:
        return None
    section = Section("cases", "All cases")
    section.blocks += table_blocks(document, limit=_MOST_ROWS)
    return section


def files_for_paraview(study):
    names = [vtu_name(study, key) for key in study.keys_with_fields()]
    if not names:
        return None
    section = Section("paraview", "For ParaView")
    section.blocks.append(
        paragraph(
            "<code>3d/</code> holds a .vtu file for each of the {} cases with fields, and "
            "<code>3d/cases.xdmf</code> opens all of them from the result file itself: "
            "displacement, deviation from the reference, reaction, V/V0 and largest spring strain "
            "of each cell. Open a file, press Apply, then Filters, Warp By Vector, displacement; or",
            len(names),
        )
    )
    section.blocks.append(Markup("<pre>pvpython 3d/show.py 3d/{}</pre>").format(names[0]))
    return section


def provenance(study):
    """Who computed the cases, with what."""
    sessions = study.results.provenance
    if sessions.empty:
        return None
    section = Section("provenance", "Provenance")
    columns = ["date", "springcheck", "commit", "revision", "compiler", "flags"]
    columns += ["deal.II", "gmsh", "Eigen", "HDF5", "BLAS", "cpu", "machine", "clock"]
    columns += ["instructions", "cores", "threads"]
    columns = [name for name in columns if name in sessions]
    tables = [table.provenance for table in (study.cases, study.limits) if not table.empty]
    counts = pd.concat(tables).value_counts() if tables else {}
    rows = []
    for place, session in sessions.iterrows():
        values = [f"{v:g}" if isinstance(v, float) else str(v) for v in session[columns]]
        rows.append([*values, str(counts.get(place, 0))])
    section.blocks.append(
        paragraph(
            "Every figure on this page is one of {} or made from its cases. The numbers in tables "
            "carry the key of their case, the same as in the column <code>key</code> of the file.",
            study.results.path.name,
        )
    )
    section.blocks.append(table([*columns, "cases"], rows, name="provenance", limit=60))
    return section
