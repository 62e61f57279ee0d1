"""The report's sections, in groups and in the page's order.

A section is a function of a Study with at least one case; it returns content.Section, or
None where the study has no data for it. A new one is a function here and its name in
GROUPS. Tables of the program's catalogue that no section draws stand below the one that the
catalogue names. A file without cases gets `empty_file` alone, one of limits alone those that read limits.
"""

from content import Section
from markupsafe import Markup
from sections.atlas import atlas
from sections.bodies import bending, compression, other_tests, shearing, tension, torsion
from sections.cases import all_cases, empty_file, files_for_paraview, provenance
from sections.cells import any_cells, convergence, subdivision
from sections.chart import chart
from sections.cost import cost
from sections.documents import titled_table
from sections.explore import explore
from sections.failures import failures
from sections.laws import error_parts, locking, modes, orientation, spring_constants
from sections.speed import speed
from sections.stability_limits import stability_limits
from sections.stability_theory import stability_theory
from sections.summary import summary
from sections.thesis_tables import thesis_tables
from sections.through_time import through_time
from sections.tissue import tissue

__all__ = ["groups_for"]

GROUPS = {
    "Answer": [summary, explore, thesis_tables],
    "Tests": [compression, tension, shearing, torsion, bending, other_tests],
    "Where methods fail": [failures, atlas, stability_limits, stability_theory],
    "Speed and accuracy": [chart, speed, cost],
    "Meshes": [any_cells, convergence, subdivision],
    "Tissue": [tissue, through_time],
    "Theory": [spring_constants, error_parts, locking, orientation, modes],
    "Data": [files_for_paraview, all_cases, provenance],
}
_OF_LIMITS = {
    "Answer": [summary, explore],
    "Where methods fail": [atlas, stability_limits],
    "Data": [all_cases, provenance],
}
_OF_NOTHING = {"Data": [empty_file]}


def groups_for(study):
    """{group: [section, ...]} of what a study has data for, without groups that have none."""
    groups = GROUPS
    if study.cases.empty:
        groups = _OF_NOTHING if study.limits.empty else _OF_LIMITS
    made = {name: [maker(study) for maker in makers] for name, makers in groups.items()}
    kept = {name: [section for section in sections if section] for name, sections in made.items()}
    if groups is GROUPS:
        kept |= {"Further tables": _further_tables(study, [one for sections in kept.values() for one in sections])}
    return {name: sections for name, sections in kept.items() if sections}


def _further_tables(study, sections):
    """Adds the tables that no section shows to their sections; returns those of tables whose section there
    is not."""
    texts = [block for section in sections for block in section.blocks if isinstance(block, Markup)]
    by_name = {section.name: section for section in sections}
    own = {}
    for name, entry in study.vocabulary["tables"].items():
        document = study.tables.get(name)
        if document is None or any(f'href="tables/{name}.csv"' in text for text in texts):
            continue
        if entry["section"] not in by_name:
            title = entry["section"].replace("-", " ").capitalize()
            by_name[entry["section"]] = own[name] = Section(entry["section"], title)
        by_name[entry["section"]].blocks += titled_table(document)
    return list(own.values())
