"""Cases in words: names of methods, loads, meshes."""

import measures
import methods
import numpy as np


def is_variant(name):
    """Whether a name is of a method with other than its usual settings."""
    return ", " in name


def method_name(case):
    """As tables call methods: fem-stvk:q1-sri; mss-cf, E-form; mss-cf, A = 0.01."""
    name = case.method
    if case.element:
        name += f":{case.element}"
    for setting, words in methods.variants().items():
        value = setting_text(case.get(setting))
        if value and value != methods.default(setting):
            name += words.format(value)
    stiffness = [case.get(f"stiffness.{axis}", np.nan) for axis in "xyz"]
    if np.isfinite(stiffness).all():
        name += ", k = " + "/".join(f"{k:.4g}" for k in stiffness)
    solver = case.get("solver")
    if solver and solver != methods.own_solver(case.method):
        name += f", {solver}"
    return name


def setting_text(value):
    """As it is written on the command line; "" of what a case lacks."""
    if value is None or isinstance(value, str):
        return value or ""
    return f"{value:.12g}" if np.isfinite(value) else ""


def load_text(case):
    """The load in words, "5 %"; "5 % at its end" of a path that ends below its whole load."""
    text = load_words(case)
    if not text or not case.get("ends_early"):
        return text
    if case.test == "bending":
        return f"{text}, {100 * case.load_fraction:.4g} % of its weight"
    return f"{text} at its end"


def load_words(case):
    """"5 %", "45°", "1 kPa"; of bending Young's modulus, which its drop depends on."""
    if case.test == "bending":
        return f"E = {case.young / 1e6:g} MPa"
    if case.test == "affine":
        parts = [(a + b, case.get(f"gradient.{a}{b}", 0)) for a in "xyz" for b in "xyz"]
        return ", ".join(f"H_{place} = {value:.3g}" for place, value in parts if value)
    if case.deformation is None or not np.isfinite(case.deformation):
        traction = [case.get(f"traction.{axis}", np.nan) for axis in "xyz"]
        if np.isfinite(traction).all():
            return f"{np.linalg.norm(traction) / 1e3:.3g} kPa"
        return ""
    if measures.turns(case.test):
        return f"{np.degrees(case.deformation):.4g}°"
    return f"{100 * case.deformation:.4g} %"


_PLURALS = {"hexahedron": "hexahedra", "tetrahedron": "tetrahedra", "prism": "prisms"}
_PLURALS |= {"pyramid": "pyramids", "free-tetrahedron": "free tetrahedra", "mixed": "mixed cells"}


def counts_text(case):
    """"10×10×10", the grid of a block."""
    return "×".join(f"{case[f'cells.{axis}']:.0f}" for axis in "xyz")


def mesh_text(case):
    """"10×10×10 hexahedra", "5×5×5 mixed cells, distorted by 0.2", "kidney"."""
    if case.body == "file":
        return f"mesh {case.mesh[:8]}"
    if case.body != "block":
        return str(case.body)
    text = f"{counts_text(case)} {_PLURALS.get(case['cell-type'], case['cell-type'])}"
    if case.get("distortion", 0) > 0:
        text += f", distorted by {case.distortion:g}"
    return text


def case_text(case):
    """A case in words, for captions and lists."""
    parts = [case.scene, mesh_text(case), f"nu {case.nu:g}", case.load, case.get("further")]
    return ", ".join(part for part in parts if part)
