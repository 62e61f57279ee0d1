#pragma once

#include <ostream>

#include "meshing/mesh.hpp"

namespace springcheck {

/// Nodes and cells as VTK unstructured grid, ASCII; coordinates read back exactly.
void write_vtu(const Mesh& mesh, std::ostream& out);

}  // namespace springcheck
