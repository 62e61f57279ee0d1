"""The report's sections, in the page's order.

A section is a function of a Study with at least one case; it returns content.Section, or
None where the study has no data for it. A new one is a function here and a line in
SECTIONS. A file without cases gets `empty_file` alone, one of limits alone LIMITS.
"""

from sections.atlas import atlas
from sections.bodies import bending, compression, other_tests, shearing, tension, torsion
from sections.cases import all_cases, empty_file, files_for_paraview, provenance
from sections.cells import any_cells, convergence, subdivision
from sections.chart import chart
from sections.cost import cost
from sections.failures import failures
from sections.laws import error_parts, locking, modes, orientation, spring_constants
from sections.speed import speed
from sections.stability_limits import stability_limits
from sections.stability_theory import stability_theory
from sections.summary import summary
from sections.thesis_tables import thesis_tables
from sections.through_time import through_time
from sections.tissue import tissue

__all__ = ["LIMITS", "SECTIONS", "empty_file"]

LIMITS = [atlas, stability_limits]

SECTIONS = [
    summary,
    thesis_tables,
    compression,
    tension,
    shearing,
    torsion,
    bending,
    other_tests,
    failures,
    atlas,
    stability_limits,
    stability_theory,
    spring_constants,
    error_parts,
    any_cells,
    convergence,
    subdivision,
    locking,
    orientation,
    modes,
    tissue,
    through_time,
    speed,
    chart,
    cost,
    files_for_paraview,
    all_cases,
    provenance,
]
