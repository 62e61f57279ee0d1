"""Files for ParaView: one .vtu for each case with fields."""

import meshio
import numpy as np
from content import file_name

# meshio's names; its order of a prism's ("wedge") nodes is gmsh's.
_TYPES = {"tetrahedra": "tetra", "pyramids": "pyramid", "prisms": "wedge", "hexahedra": "hexahedron"}
_NODE_FIELDS = {"displacement": "m", "deviation": "m", "reaction": "N"}  # and units
_CELL_FIELDS = ["cell_volume_ratio", "spring_strain"]


def vtu_name(study, key):
    """The name of a case's file: "compression-mss-cf-nu-0.25-5-0123abcd.vtu"."""
    case = study.cases.loc[key]
    text = file_name(f"{case.scene} {case['name']} nu {case.nu:g} {case.load}")[:60].strip("-.")
    return f"{text}-{key[:8]}.vtu"


def write_vtu(study, key, folder):
    """Writes the case's mesh with its fields; those of a case that ended without an
    equilibrium are named partial_, as in the result file."""
    mesh = study.mesh(key)
    blocks = [(_TYPES[name], mesh[name]) for name in _TYPES if name in mesh]
    point_data, cell_data = {}, {}
    for prefix in ("", "partial_"):
        for name, unit in _NODE_FIELDS.items():
            values = study.field(key, prefix + name)
            if values is not None:
                point_data[f"{prefix}{name} [{unit}]"] = values
        for name in _CELL_FIELDS:
            values = study.field(key, prefix + name)
            if values is not None:
                ends = np.cumsum([len(cells) for _, cells in blocks])[:-1]
                cell_data[prefix + name] = np.split(values, ends)
    path = folder / vtu_name(study, key)
    meshio.Mesh(mesh["nodes"], blocks, point_data, cell_data).write(path, binary=True)
    return path.name
