#pragma once

#include <span>

#include "meshing/basics/vector3.hpp"
#include "meshing/generators/block.hpp"

namespace springcheck {

/// Moves each node that is inside the block along each axis by a number drawn uniformly
/// from -d to d cell edges, d = block.distortion, in the order of nodes and axes.
void distort(const Block& block, std::span<Vector3> nodes);

}  // namespace springcheck
