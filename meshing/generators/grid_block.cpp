#include "meshing/generators/grid_block.hpp"

#include "meshing/generators/distortion.hpp"
#include "meshing/generators/hexahedron_cuts.hpp"
#include "meshing/generators/mixed_grid.hpp"

namespace springcheck {
namespace {

std::vector<Vector3> grid_nodes(const Block& block) {
  std::vector<Vector3> nodes;
  const auto at = [&](std::size_t axis, int i) {
    // The last plane exactly at the size: the quotient may miss it by a rounding.
    return i == block.cells[axis] ? block.size[axis]
                                  : block.size[axis] * i / block.cells[axis];
  };
  for (int k = 0; k <= block.cells[2]; ++k)
    for (int j = 0; j <= block.cells[1]; ++j)
      for (int i = 0; i <= block.cells[0]; ++i)
        nodes.emplace_back(at(0, i), at(1, j), at(2, k));
  return nodes;
}

struct GridCell {
  CellNodes hexahedron;
  bool is_even;  // i + j + k
};

/// Cells of the grid, x fastest.
std::vector<GridCell> grid_cells(const std::array<int, 3>& cells) {
  const auto [along_x, along_y, along_z] = cells;
  const auto node = [&](int i, int j, int k) {
    return static_cast<NodeIndex>(i) +
           static_cast<NodeIndex>(along_x + 1) *
               (static_cast<NodeIndex>(j) +
                static_cast<NodeIndex>(along_y + 1) * static_cast<NodeIndex>(k));
  };
  std::vector<GridCell> found;
  for (int k = 0; k < along_z; ++k)
    for (int j = 0; j < along_y; ++j)
      for (int i = 0; i < along_x; ++i)
        found.push_back(
            {.hexahedron = {node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k),
                            node(i, j + 1, k), node(i, j, k + 1), node(i + 1, j, k + 1),
                            node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)},
             .is_even = (i + j + k) % 2 == 0});
  return found;
}

/// Adds the mean of the hexahedron's corners to the nodes and returns its number.
NodeIndex add_centre(const CellNodes& hexahedron, std::vector<Vector3>& nodes) {
  nodes.push_back(mean_of(hexahedron, nodes));
  return static_cast<NodeIndex>(nodes.size() - 1);
}

std::vector<CellNodes> mixed_cells(const MixedGridCell& cell, const CellNodes& hexahedron,
                                   std::vector<Vector3>& nodes) {
  switch (cell.cut) {
    case MixedCut::hexahedron:
      return {hexahedron};
    case MixedCut::centre:
      return cells_around(add_centre(hexahedron, nodes), hexahedron, cell.is_cut);
    case MixedCut::prisms_along_x:
      return prisms_along(0, hexahedron);
    case MixedCut::prisms_along_y:
      return prisms_along(1, hexahedron);
    default:
      return prisms_along(2, hexahedron);
  }
}

constexpr std::array no_face{false, false, false, false, false, false};
constexpr std::array each_face{true, true, true, true, true, true};

/// What the cell becomes in any pattern but the mixed one; adds its centre where needed.
std::vector<CellNodes> cut(const GridCell& cell, CellPattern pattern,
                           std::vector<Vector3>& nodes) {
  const auto& [hexahedron, is_even] = cell;
  switch (pattern) {
    case CellPattern::tetrahedron:
      return six_tetrahedra(hexahedron);
    case CellPattern::tetrahedron_5:
      return five_tetrahedra(hexahedron, is_even);
    case CellPattern::tetrahedron_12:
      return cells_around(add_centre(hexahedron, nodes), hexahedron, each_face);
    case CellPattern::pyramid:
      return cells_around(add_centre(hexahedron, nodes), hexahedron, no_face);
    case CellPattern::prism:
      return prisms_along(2, hexahedron);
    default:
      return {hexahedron};
  }
}

}  // namespace

MeshParts grid_block(const Block& block) {
  MeshParts parts{.nodes = grid_nodes(block)};
  distort(block, parts.nodes);
  const std::vector<GridCell> grid = grid_cells(block.cells);
  const bool is_mixed = block.pattern == CellPattern::mixed;
  const std::vector<MixedGridCell> mixed =
      is_mixed ? mixed_grid(block.cells, block.seed) : std::vector<MixedGridCell>{};
  for (std::size_t c = 0; c < grid.size(); ++c) {
    const std::vector<CellNodes> cells =
        is_mixed ? mixed_cells(mixed[c], grid[c].hexahedron, parts.nodes)
                 : cut(grid[c], block.pattern, parts.nodes);
    parts.cells.insert(parts.cells.end(), cells.begin(), cells.end());
  }
  return parts;
}

}  // namespace springcheck
