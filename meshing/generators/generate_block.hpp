#pragma once

#include "meshing/generators/block.hpp"
#include "meshing/mesh.hpp"

namespace springcheck {

/// Mesh of the block, with the regions bottom (z = 0), top (z = height), x_min, x_max,
/// y_min, y_max. Nodes of the grid are numbered lexicographically, x fastest, and stand
/// exactly on it; cells follow their hexahedra in the same order. Centre nodes come
/// behind.
///
/// Throws InputError for sizes that are not positive and finite, fewer than one cell
/// along an axis, more nodes than NodeIndex counts, and a distortion that is negative or
/// not finite; when a cell that the distortion leaves has no positive Jacobian at a
/// corner; and when the total volume is not the box's.
Mesh generate_block(const Block& block);

}  // namespace springcheck
