#pragma once

#include "meshing/generators/block.hpp"
#include "meshing/mesh_parts.hpp"

namespace springcheck {

/// Nodes and cells of the block in one of the patterns that gmsh makes; nodes on its
/// sides stand exactly there, and neighbours close in memory (along_z_curve). The edge
/// length is the mean of size/cells along the three axes, in free_prism along x and y,
/// with as many layers of prisms as cells along z. transition: see transition_block.
///
/// Throws std::runtime_error with gmsh's own words when it fails.
MeshParts free_block(const Block& block);

}  // namespace springcheck
