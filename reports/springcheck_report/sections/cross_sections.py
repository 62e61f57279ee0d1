"""Figures 5.11 and 5.13: sections through springs and finite elements."""

import methods
import numpy as np
from case_words import is_variant
from content import Figure
from figures import cross_sections
from surface import edges_in_plane


def cross_section(study, test, plane, across):
    """Springs over finite elements in the middle plane normal to axis `plane`."""
    pairs = _pairs_of_bodies(study, test)
    if not pairs:
        return []
    sections = []
    for springs, elements in pairs:
        mesh = study.mesh(springs)
        coordinates = mesh["nodes"][:, plane]
        position = _layer(coordinates)
        edges = edges_in_plane(mesh, plane, position, 1e-6 * np.ptp(coordinates))
        if len(edges) == 0:
            return []
        lines = []
        for key in (elements, springs):
            deformed = 100 * (mesh["nodes"] + study.field(key, "displacement"))
            lines.append((study.cases.loc[key, "name"], deformed[edges][:, :, across]))
        title = f"ν = {study.cases.loc[springs].nu:g}"
        sections.append(cross_sections.Section(title, lines))
    axes = "xyz"
    caption = (
        f"The layer of nodes at {axes[plane]} = {100 * position:.3g} cm after {test} by "
        f"{study.cases.loc[pairs[0][0]].load}, springs over finite elements (the pale lines), seen "
        f"along {axes[plane]}."
    )
    labels = [f"{axes[axis]} [cm]" for axis in across]
    name = f"cross_section_{test}_{axes[plane]}"
    return [Figure(name, caption, cross_sections.draw, (sections, *labels))]


def _pairs_of_bodies(study, test):
    """(key of springs, key of finite elements) at the test's largest load on the mesh with
    the most values of nu, for up to three of them; one method and one law for all."""
    cases = study.with_fields(study.cases[(study.cases.test == test) & (study.cases.body == "block")])
    usable = cases[(cases.status == "ok") & ~cases["name"].map(is_variant)]
    springs = usable[usable.kind != "finite elements"]
    elements = usable[(usable.kind == "finite elements") & usable.problem.isin(springs.problem)]
    springs = springs[springs.problem.isin(elements.problem)]
    if springs.empty:
        return []
    name = methods.of_thesis()
    if name not in set(springs["name"]):
        name = springs["name"].iloc[0]
    springs = springs[springs["name"] == name]
    loads = springs.groupby(["mesh", "deformation"], dropna=False)
    springs = max(
        (group for _, group in loads),
        key=lambda group: (
            min(group.nu.nunique(), 3),
            np.nan_to_num(group.deformation.iloc[0]),
            len(study.mesh(group.index[0])["nodes"]),
        ),
    )
    laws = elements[elements.problem.isin(springs.problem)].groupby("name").problem.nunique()
    law = max(laws.index, key=lambda name: (laws[name], name.startswith(methods.reference_law()), name))
    elements = elements[elements["name"] == law].drop_duplicates("problem")  # beside any reference
    keys = elements.reset_index().set_index("problem").key
    springs = springs[springs.problem.isin(keys.index)].drop_duplicates("nu").sort_values("nu")
    if len(springs) > 3:
        springs = springs.iloc[[0, len(springs) // 2, -1]]
    return [(key, keys[case.problem]) for key, case in springs.iterrows()]


def _layer(coordinates):
    """The coordinate, among those of nodes, that is nearest to the middle."""
    values = np.unique(coordinates)
    return values[np.abs(values - (values[0] + values[-1]) / 2).argmin()]
