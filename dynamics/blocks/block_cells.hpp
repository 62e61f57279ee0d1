#pragma once

#include <Eigen/Core>
#include <optional>

#include "dynamics/blocks/blocks.hpp"

// Cells of blocks as kernels see them.
namespace springcheck::dynamics {

/// The places of a block's cells in BlockArrays.
struct BlockCells {
  std::size_t row, layer;  // of Block
  std::size_t count;       // with those that do not exist
  // Without a grid, the elements of each cell's corners:
  std::vector<std::array<std::uint32_t, 8>> corners;
};

BlockCells cells_in_arrays(const Block& block, std::size_t lanes);

/// The element of BlockArrays that a slot is.
std::size_t element_of(const Block& block, std::size_t slot, std::size_t lanes);

/// The number a kernel knows a cell by: in a grid the element of its corner 0.
std::size_t number_of(const Block& block, std::size_t cell, std::size_t lanes);

/// Calls visit(cell, slots of its corners) for each cell that exists.
template <class Visit>
void for_each_cell(const Block& block, const Visit& visit) {
  for (std::size_t cell = 0; cell < block.cells.size(); ++cell)
    if (block.cells[cell] != no_cell) visit(cell, block.corner_slots(cell));
}

/// Positions differ from those of a perfect grid by no more than this, their rounding
/// [m].
double rounding_of(std::span<const Vector3> positions);

/// The edges that leave corner 0, as columns, if the block's cells are all the same
/// parallelepiped but for that rounding, and in a grid.
std::optional<Eigen::Matrix3d> common_edges(const Block& block,
                                            std::span<const Vector3> positions,
                                            double rounding);

}  // namespace springcheck::dynamics
