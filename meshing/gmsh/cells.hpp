#pragma once

#include "meshing/mesh_parts.hpp"

namespace springcheck {

/// The three-dimensional cells of gmsh's current model, right way round, with the nodes
/// they use. A gmsh session must be open.
MeshParts gmsh_cells();

}  // namespace springcheck
