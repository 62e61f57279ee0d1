#pragma once

#include "meshing/generators/block.hpp"
#include "meshing/mesh_parts.hpp"

namespace springcheck {

/// Nodes and cells of the block in one of the patterns that keep the grid.
MeshParts grid_block(const Block& block);

}  // namespace springcheck
