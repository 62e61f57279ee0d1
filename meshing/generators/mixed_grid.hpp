#pragma once

#include <array>
#include <vector>

namespace springcheck {

/// What a hexahedron of the grid becomes in a mixed mesh.
enum class MixedCut {
  hexahedron,
  prisms_along_x,
  prisms_along_y,
  prisms_along_z,
  centre
};

struct MixedGridCell {
  MixedCut cut;
  std::array<bool, 6> is_cut;  // its faces, in the order of faces(CellType::hexahedron)
};

/// Draws a cut for each cell of the grid, x fastest, as evenly as the cells before it
/// allow: prisms cut the faces at their ends, which hexahedra and the sides of other
/// prisms cannot share; cells cut around their centre take any face, and cut those
/// between two of them.
///
/// Draws again, 1000 times at most, until the cells are of all four types. The smallest
/// grids that can be have three cells in a row or two by two.
std::vector<MixedGridCell> mixed_grid(const std::array<int, 3>& cells, unsigned seed);

}  // namespace springcheck
