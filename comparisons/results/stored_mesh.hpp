#pragma once

#include <hdf5.h>

#include <pugixml.hpp>
#include <string>

#include "meshing/mesh.hpp"

namespace springcheck {

/// Writes the mesh into a group of its SHA-256's name: `nodes`; `tetrahedra`, `pyramids`,
/// `prisms` and `hexahedra`, those there are, in gmsh's order of nodes; with prisms or
/// several types also `xdmf_topology`, the same cells as XDMF reads them; `regions/NAME`,
/// four nodes a face, of triangles the last one twice.
void write_stored_mesh(hid_t meshes, const Mesh& mesh);

/// Appends XDMF's topology and geometry of the mesh in a group, whose path in the file
/// `in_mesh` names.
void append_xdmf_mesh(pugi::xml_node grid, hid_t mesh, const std::string& in_mesh);

std::size_t stored_cell_count(hid_t mesh);

}  // namespace springcheck
