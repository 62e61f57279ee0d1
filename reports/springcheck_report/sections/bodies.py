"""The five tests, and others: 3D views, pictures, sections, beams."""

import bodies
import measures
import methods
import numpy as np
from case_words import is_variant
from content import Figure, Section, Viewer, measured_number, paragraph, table
from figures import bodies as body_figures
from markupsafe import Markup
from numbers_shown import significant
from sections.beams import beams_against_theory, diagonal_ratio_beams
from sections.cross_sections import cross_section
from sections.slices import explorer_links
from surface import outside

_OWN = ("compression", "tension", "shearing", "torsion", "bending")  # tests that have a section each


def compression(study):
    """Figure 5.9."""
    return _test(study, "compression")


def tension(study):
    """Figure 5.10."""
    return _test(study, "tension")


def shearing(study):
    """Figures 5.11 and 5.12: the vertical plane in the middle, along the motion."""
    return _test(study, "shearing", cross_section(study, "shearing", plane=1, across=(0, 2)))


def torsion(study):
    """Figures 5.13 and 5.14: the layer at half height, seen along the axis, and the vertical
    plane in the middle, whose points turn out of it."""
    blocks = cross_section(study, "torsion", plane=1, across=(0, 2))
    return _test(study, "torsion", blocks + cross_section(study, "torsion", plane=2, across=(0, 1)))


def bending(study):
    """Figures 5.3 and 5.15 to 5.19."""
    return _test(study, "bending", beams_against_theory(study) + diagonal_ratio_beams(study))


def other_tests(study):
    """Whatever else the file has fields of."""
    section = Section("other-tests", "Other tests")
    for test in sorted(set(study.cases.test) - set(_OWN)):
        blocks = _views(study, test)
        if blocks:
            section.blocks += [Markup("<h3>{}</h3>").format(test), *blocks]
    return section if section.blocks else None


def _test(study, test, further=()):
    blocks = [*explorer_links(study, test), *_views(study, test), *further]
    if not blocks:
        return None
    title = test.capitalize()
    return Section(test, title, [paragraph(measures.description(test)), *_verdicts(study, test), *blocks])


def _verdicts(study, test):
    """Per spring method how far its answer is from finite elements on the same problem."""
    cases = study.cases[(study.cases.test == test) & (study.cases.kind != "finite elements")]
    measure, answer, unit = measures.answer(test)
    rows = []
    for name, of_method in cases.groupby("name"):
        judged = of_method[(of_method.status == "ok") & of_method.answer_difference.notna()]
        judged = judged[~judged.is_repeated]
        if judged.is_judged.any():
            judged = judged[judged.is_judged]
        if judged.empty or is_variant(name):
            continue
        worst = judged.answer_difference.abs().idxmax()
        case = judged.loc[worst]
        theirs = study.cases.loc[case.counterpart]
        rows.append(
            [
                Markup("<b>{}</b>").format(name),
                str(len(judged)),
                _percent(judged.answer_difference.abs().median()),
                _percent(abs(case.answer_difference)),
                bodies.group_text(case),
                measured_number(study, worst, measure, significant(case.answer)),
                measured_number(study, case.counterpart, measure, significant(theirs.answer)),
                theirs["name"] + ("" if case.is_judged else " (linear: too stiff)"),
            ]
        )
    if not rows:
        return []
    unit = unit.replace(" ", "\u00a0")
    headings = ["springs", "cases", "median", "largest", "the largest at", f"springs [{unit}]"]
    headings += [f"finite elements [{unit}]", "their law"]
    note = paragraph(
        '<span class="note">{} off finite elements on the same mesh, in cases that both solve. At '
        "large deformation the laws differ, not only the methods. Linear finite elements on other "
        "cells than hexahedra are too stiff, the more the nearer nu is to 0.5: there the difference "
        "says little about the springs.</span>",
        answer.capitalize(),
    )
    return [table(headings, rows, name=f"answers-{test}"), note]


def _percent(fraction):
    return f"{significant(100 * fraction, 2)} %"


def _views(study, test):
    """The interactive view and the picture that stands for it in print."""
    found = bodies.groups(study, test)
    if not found:
        return []
    return [Viewer(test), _picture(study, test, found)]


def _picture(study, test, found):
    """Methods beside each other, a row for each Poisson's ratio (figures 5.9, 5.10, 5.12,
    5.14) or Young's modulus (5.15), at the largest load that most methods have."""
    first = study.cases.loc[found[0].cases[0]]
    chosen = [
        group
        for group in found
        if study.cases.loc[group.cases[0], "mesh"] == first["mesh"]
        and study.cases.loc[group.cases[0], "load"] == _picture_load(study, found, first)
    ] or [found[0]]
    chosen.sort(key=lambda group: study.cases.loc[group.cases[0], "nu"])
    if len(chosen) > 3:
        chosen = [chosen[0], chosen[len(chosen) // 2], chosen[-1]]
    names = _columns(study, chosen)
    surface = outside(study.mesh(first.name))
    rows = []
    for group in chosen:
        by_name = {study.cases.loc[key, "name"]: key for key in group.cases}
        if len(by_name.keys() & set(names)) < min(2, len(names)):
            continue
        rows.append(
            [
                _panel(study, by_name[name], surface) if name in by_name else _no_body(study, group, name)
                for name in names
            ]
        )
    case = study.cases.loc[chosen[0].cases[0]]
    text = f"Deformed bodies, {_mesh_and_load(case)}, coloured by displacement, all to the same scale."
    kinds = [study.cases[study.cases["name"] == name].kind.iloc[0] for name in names]
    if 0 < kinds.count("finite elements") < len(kinds):
        text += " Springs are on the left, finite elements on the right."
    return Figure(f"bodies_{test}", text, body_figures.draw, (rows, "displacement [mm]", 1e3))


def _picture_load(study, found, first):
    """The largest load among groups with the largest number of methods on the mesh."""
    on_mesh = [g for g in found if study.cases.loc[g.cases[0], "mesh"] == first["mesh"]]
    most = max(len(_columns(study, [g])) for g in on_mesh)
    loads = [
        (_size_of_load(study.cases.loc[g.cases[0]]), study.cases.loc[g.cases[0], "load"])
        for g in on_mesh
        if len(_columns(study, [g])) >= min(most, 3)
    ]
    return max(loads)[1]


def _size_of_load(case):
    if case.test == "bending":
        return 1 / case.young
    return abs(case.deformation) if np.isfinite(case.deformation) else 0.0


def _columns(study, chosen):
    """Names of up to four spring methods and one of finite elements."""
    cases = [study.cases.loc[key] for group in chosen for key in group.cases]
    names = {}
    for case in [case for case in cases if not is_variant(case["name"])] or cases:
        names.setdefault(case["name"], [case["kind"], 0])[1] += 1
    springs = [name for name, (kind, _) in names.items() if kind != "finite elements"]
    order = ["mss-baudet", "mss-nfd", "mss-cf", "mss-affine"]
    springs.sort(key=lambda name: (order.index(name) if name in order else len(order), name))
    elements = [name for name, (kind, _) in names.items() if kind == "finite elements"]
    elements.sort(key=lambda name: (-names[name][1], not name.startswith(methods.reference_law()), name))
    return springs[:4] + elements[:1]


def _panel(study, key, surface):
    case = study.cases.loc[key]
    mesh = study.mesh(key)
    displacement = study.field(key, "displacement")[surface.nodes]
    corners = (mesh["nodes"][surface.nodes] + displacement)[surface.faces]
    values = np.linalg.norm(displacement, axis=1)[surface.faces].mean(axis=1)
    title = f"{case['name']}\nν = {case.nu:g}"
    if case.status != "ok":
        title += f", {case.status.replace('_', ' ')}"
    return body_figures.Panel(title, corners, values)


def _no_body(study, group, name):
    """Says how the method's case on the same problem ended."""
    problem = study.cases.loc[group.cases[0]]
    same = study.cases[(study.cases.whole_problem == problem.whole_problem) & (study.cases["name"] == name)]
    words = "not computed" if same.empty else same.status.iloc[0].replace("_", " ")
    if not same.empty and np.isfinite(same.volume_change.iloc[0]):
        words = "body not stored" if same.load.iloc[0] == problem.load else f"only to {same.load.iloc[0]}"
    return body_figures.Panel(f"{name}\nν = {problem.nu:g}\n{words}", None, None)


def _mesh_and_load(case):
    parts = bodies.group_text(case).split(", ")
    return ", ".join(part for part in parts if not part.startswith("nu "))
