#pragma once

#include <ostream>

#include "meshing/mesh.hpp"

namespace springcheck {

/// As input for CalculiX, without pyramids, which it does not have. See write_mesh.
void write_inp(const Mesh& mesh, std::ostream& out);

}  // namespace springcheck
