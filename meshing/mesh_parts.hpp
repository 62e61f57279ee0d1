#pragma once

#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck {

/// Nodes [m] and cells on the way to a Mesh, not checked yet.
struct MeshParts {
  std::vector<Vector3> nodes;
  std::vector<CellNodes> cells{};
};

}  // namespace springcheck
