#pragma once

#include <ostream>

#include "meshing/mesh.hpp"

namespace springcheck {

/// Nodes, cells and named regions as gmsh .msh 4.1 (ASCII), so that read_msh gives the
/// same mesh bit by bit; node and cell tags are our indices plus one. Everything is in
/// the physical volume "body", each region a physical surface of its name.
void write_msh(const Mesh& mesh, std::ostream& out);

}  // namespace springcheck
