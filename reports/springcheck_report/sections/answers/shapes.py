"""What deformed bodies look like, and how far springs' points are from those of elements."""

import bodies
import numpy as np
from content import Answer, Figure
from figures import bodies as body_figures
from markupsafe import Markup
from sections.answers.words import SIZE, bold, case_number, first_and_nearest, foremost_springs, gone_through
from study import USABLE
from surface import outside


_ORDER = ["torsion", "shearing", "compression", "tension", "bending"]  # what shows most first


def look_of_bodies(study):
    """Of the first test in which springs stand beside finite elements that judge them."""
    for test in _ORDER:
        for group in bodies.groups(study, test)[:1]:
            cases = study.cases.loc[group.cases]
            springs = cases[~cases.is_repeated & cases.is_judged & (cases.status == USABLE)]
            springs = springs[springs.counterpart.isin(cases.index)]
            names = foremost_springs(springs["name"])
            if not names:
                continue
            judge = springs[springs["name"] == names[0]].iloc[0].counterpart
            judged = springs[springs.counterpart == judge]
            keys = {name: judged.index[judged["name"] == name][0] for name in foremost_springs(judged["name"])}
            return _answer(study, test, group, judge, keys)
    return None


def _answer(study, test, group, judge, keys):
    surface = outside(study.mesh(group.cases[0]))
    distances = {name: _distances(study, key, judge, surface) for name, key in keys.items()}
    named = first_and_nearest({name: found.max() for name, found in distances.items()})
    panels = [_panel(study, keys[name], name, surface, distances[name]) for name in named]
    law = study.cases.loc[judge, "name"]
    panels.append(_panel(study, judge, f"{law}\nfinite elements", surface, np.zeros(len(surface.nodes))))
    parts = [
        Markup("{} up to {} mm").format(bold(name), case_number(1000 * distances[name].max(), keys[name]))
        for name in named
    ]
    moved = np.linalg.norm(study.field(judge, "displacement")[surface.nodes], axis=1).max()
    sentence = Markup("{}: points of {} from those of {}, which move by up to {} mm.").format(
        gone_through(test, study.cases.loc[judge].load),
        Markup(", of ").join(parts),
        bold(law),
        case_number(1000 * moved, judge),
    )
    caption = (
        f"Deformed bodies, {group.label}, coloured by the distance of springs' points from those of {law}: "
        "the first springs of those that it judges, and the nearest."
    )
    arguments = ([panels], "distance [mm]", 1e3, SIZE[0] - 0.3)
    figure = Figure("answer_bodies", caption, body_figures.draw, arguments)
    return Answer("What do the bodies look like?", figure, sentence, test)


def _distances(study, key, judge, surface):
    """Of the surface's points [m]."""
    apart = study.field(key, "displacement") - study.field(judge, "displacement")
    return np.linalg.norm(apart[surface.nodes], axis=1)


def _panel(study, key, title, surface, distances):
    nodes = study.mesh(key)["nodes"] + study.field(key, "displacement")
    corners = nodes[surface.nodes][surface.faces]
    return body_figures.Panel(title, corners, distances[surface.faces].mean(axis=1))
