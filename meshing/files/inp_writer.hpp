#pragma once

#include <ostream>

#include "meshing/mesh.hpp"

namespace springcheck {

/// Writes a mesh as input for CalculiX, without pyramids, which it does not have. See
/// write_mesh.
void write_inp(const Mesh& mesh, std::ostream& out);

}  // namespace springcheck
