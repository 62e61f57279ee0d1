#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "dynamics/blocks/hexahedron_grid.hpp"

namespace springcheck::dynamics {

inline constexpr NodeIndex no_node = ~NodeIndex{0};
inline constexpr std::uint32_t no_cell = ~std::uint32_t{0};

/// Every list over a block's slots or cells is a multiple of this long: whole registers
/// of the widest kind.
inline constexpr std::size_t block_granularity = 16;

/// A part of the mesh small enough for a core's cache. Nodes on its border have a slot in
/// each of the blocks that share them. Slots and cells beyond the last are empty.
struct Block {
  std::vector<NodeIndex> nodes;      // of the mesh, slot by slot; no_node: empty
  std::vector<std::uint32_t> cells;  // of the mesh; no_cell: empty
  // In a grid, node (i, j, k) has the slot i + row j + layer k, and a cell has the number
  // of the slot of its corner 0. Both are 0 without a grid.
  std::size_t row = 0;
  std::size_t layer = 0;
  // Without a grid, the eight slots of each cell, in the order of GridCell::corners:
  std::vector<std::array<std::uint32_t, 8>> corners{};

  [[nodiscard]] bool is_grid() const { return row != 0; }
  [[nodiscard]] std::array<std::uint32_t, 8> corner_slots(std::size_t cell) const;
};

/// Cuts a mesh of hexahedra into blocks of about equal numbers of cells, by planes across
/// the longest extent. The blocks depend on the mesh alone, and so do the sums made over
/// them, whatever the number of threads.
std::vector<Block> grid_blocks(const std::vector<GridCell>& grid);
std::vector<Block> free_blocks(const Mesh& mesh);

/// The whole mesh, of any cells, as one block without corners: slots are its nodes.
Block whole_mesh(const Mesh& mesh);

}  // namespace springcheck::dynamics
