#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "meshing/generators/generate_block.hpp"

namespace springcheck {

/// Numbers of cells of a block along x, y, z; nodes and cells of its mesh are numbered
/// lexicographically, x fastest (generate_block).
using Cells = std::array<int, 3>;

/// The counts, each times `factor`. Throws InputError where one would not fit an int.
Cells refined(const Cells& cells, int factor);

/// The counts, each halved, odd ones rounded up.
Cells coarsened(const Cells& cells);

/// Whether each count of `fine` is a whole multiple of the one of `coarse`: then every
/// node of the coarse grid is one of the fine grid.
bool is_refinement(const Cells& fine, const Cells& coarse);

/// Cube root of a cell's mean volume [m].
double cell_size(const Block& block);

/// A field at points in the block [m] from its values at the nodes of a regular grid:
/// along an axis with an even number of cells quadratic in each pair of them, linear in
/// each cell along others. At a point within 1e-9 cells of a node it is the node's value.
std::vector<Vector3> interpolated(std::span<const Vector3> field, const Block& grid,
                                  std::span<const Vector3> points);

/// Whether all points are nodes of the regular grid, within 1e-9 of its cells.
bool are_nodes_of(const Block& grid, std::span<const Vector3> points);

/// The sums of `values` over the fine cells in each coarse cell.
std::vector<double> summed_over_coarse_cells(std::span<const double> values,
                                             const Cells& fine, const Cells& coarse);

}  // namespace springcheck
