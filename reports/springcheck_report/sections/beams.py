"""Figures 5.3 and 5.16 to 5.19: centre lines of beams."""

import methods
import numpy as np
from case_words import counts_text, is_variant
from content import Figure
from figures import beams
from method_style import NEUTRAL, line, shades


def beams_against_theory(study):
    """A figure for each size of beam, a panel for each Young's modulus."""
    cases = study.cases[(study.cases.test == "bending") & (study.cases.body == "block")]
    cases = cases[~cases["name"].map(is_variant) & (cases["cell-type"] == "hexahedron")]
    cases = cases[np.isclose(cases.nu, 0.25)]
    figures = []
    for length, of_length in cases.groupby("size.z"):
        panels = []
        gravity = np.linalg.norm(of_length[[f"gravity.{axis}" for axis in "xyz"]].to_numpy(float), axis=1)
        of_length = of_length.assign(weight=gravity)[gravity > 0]
        of_length = of_length.sort_values(["weight", "young"], ascending=[False, True], kind="stable")
        for (young, weight), of_modulus in of_length.groupby(["young", "weight"], sort=False):
            lines = []
            for key, case in of_modulus.sort_values(["method", "cells.z"]).iterrows():
                curve = _centre_line(study, key)
                if curve is None:
                    continue
                name = f"{case['name']} {counts_text(case)}"
                style = {**line(case["name"]), "markersize": 0}
                if case.status != "ok":
                    name += f" ({case.status.replace('_', ' ')})"
                    style["linestyle"] = (0, (1, 1))
                style["alpha"] = 1.0 if case["cells.x"] == of_modulus["cells.x"].max() else 0.45
                lines.append(beams.CentreLine(name, *curve, style))
            if lines:
                theory = _theory_lines(study, of_modulus.index[0])
                title = f"E = {young / 1e6:g} MPa, nu = 0.25"
                if of_length.weight.nunique() > 1:
                    title += f", {weight:g} m/s²"
                panels.append((title, theory, lines))
        if panels:
            panels = sorted(panels, key=lambda panel: -len(panel[2]))[:2]
            caption = (
                f"Centre lines of beams {length:g} m long against theory: Euler-Bernoulli is for "
                "small deflections, the elastica for large ones without shear. Paler lines are "
                "coarser meshes, dotted ones wrinkled states; at nu = 1/4 mss-baudet and mss-nfd are "
                "the same springs."
            )
            figures.append(Figure(f"beams_{100 * length:.3g}cm", caption, beams.draw, (panels,)))
    return figures


def diagonal_ratio_beams(study):
    """Figure 5.3: the ratio A of the diagonals' stiffness."""
    cases = study.cases[(study.cases.test == "bending") & (study.cases.method == methods.of_thesis())]
    cases = study.with_fields(cases)
    panels = []
    for _, same in cases.groupby(["mesh", "young", "nu"]):
        if same["diagonal-ratio"].nunique() < 3:
            continue
        same = same.drop_duplicates("diagonal-ratio").sort_values("diagonal-ratio")
        lines = []
        for i, (key, case) in enumerate(same.iterrows()):
            curve = _centre_line(study, key)
            if curve is not None:
                shade = {"color": shades(len(same))[i], "linewidth": 1.1}
                status = "" if case.status == "ok" else f" ({case.status.replace('_', ' ')})"
                lines.append(beams.CentreLine(f"A = {case['diagonal-ratio']:g}{status}", *curve, shade))
        case = same.iloc[0]
        theory = _theory_lines(study, same.index[0])
        panels.append((f"{case.load}, nu = {case.nu:g}, {counts_text(case)}", theory, lines))
    if not panels:
        return []
    caption = (
        "The ratio A of face to inner diagonals' stiffness in mss-cf, which its small-strain "
        "moduli do not depend on. The thesis saw no noticeable influence from 0.01 to 100."
    )
    return [Figure("beam_diagonal_ratio", caption, beams.draw, (panels[:2],))]
def _centre_line(study, key):
    """Axial place and drop of the nodes on the middle axis, None where there are none."""
    displacement = study.field(key, "displacement")
    if displacement is None:
        return None
    mesh, case = study.mesh(key), study.cases.loc[key]
    nodes = mesh["nodes"]
    middle = np.array([case["size.x"], case["size.y"]]) / 2
    on_axis = np.abs(nodes[:, :2] - middle).max(axis=1) < 1e-9 * case["size.z"]
    if on_axis.sum() < 3:
        return None
    order = np.argsort(nodes[on_axis, 2])
    deformed = (nodes + displacement)[on_axis][order]
    return deformed[:, 2], -displacement[on_axis][order, 0]


def _theory_lines(study, key):
    """Curves of beam theory for the case's beam."""
    styles = {
        "euler_bernoulli": ("Euler-Bernoulli", {"color": NEUTRAL[0], "linestyle": ":"}),
        "timoshenko": ("Timoshenko", {"color": NEUTRAL[1], "linestyle": "-."}),
        "elastica": ("elastica", {"color": NEUTRAL[2], "linestyle": "-", "linewidth": 2.5}),
    }
    for beam in study.theory.get("beams", []):
        if key in beam["cases"]:
            return [
                beams.CentreLine(
                    name, np.array(beam[theory]["axial"]), np.array(beam[theory]["drop"]), style
                )
                for theory, (name, style) in styles.items()
            ]
    return []
