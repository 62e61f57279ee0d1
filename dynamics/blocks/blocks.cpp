#include "dynamics/blocks/blocks.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "meshing/cell_geometry.hpp"

namespace springcheck::dynamics {
namespace {

// A block of 4096 cells is 16^3: its state fills half of a 1 MB cache. Small meshes still
// get enough blocks for a few threads.
constexpr std::size_t most_cells = 4096, fewest_cells = 500, wanted_blocks = 4;
constexpr std::size_t sparse_cells = 64;  // a block mostly of holes is cut down to this

std::size_t cells_per_block(std::size_t cells) {
  return std::clamp(cells / wanted_blocks, fewest_cells, most_cells);
}

std::size_t rounded_up(std::size_t count) {
  return (count + block_granularity - 1) / block_granularity * block_granularity;
}

using Place = std::array<double, 3>;

/// Cuts the cells, numbers into `places`, and passes every part to take(cells).
template <class Take>
void bisect(std::span<std::uint32_t> cells, const std::vector<Place>& places,
            std::size_t parts, const Take& take) {
  if (parts <= 1 || cells.size() < 2) return take(cells);
  std::size_t axis = 0;
  double longest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [low, high] =
        std::ranges::minmax(cells, {}, [&](std::uint32_t c) { return places[c][i]; });
    const double extent = places[high][i] - places[low][i];
    if (extent > longest) {
      longest = extent;
      axis = i;
    }
  }
  const auto order = [&](std::uint32_t c) { return std::pair(places[c][axis], c); };
  std::ranges::sort(cells, {}, order);
  std::size_t cut = cells.size() * (parts / 2) / parts;
  // Grid planes stay whole: the nearer end of the plane that the cut would divide.
  const double plane = places[cells[cut]][axis];
  const auto at = [&](std::uint32_t c) { return places[c][axis]; };
  const auto from = static_cast<std::size_t>(
      std::ranges::lower_bound(cells, plane, {}, at) - cells.begin());
  const auto to = static_cast<std::size_t>(
      std::ranges::upper_bound(cells, plane, {}, at) - cells.begin());
  cut = from > 0 && (cut - from <= to - cut || to == cells.size()) ? from : to;
  if (cut == cells.size()) return take(cells);  // all in one plane across every axis
  bisect(cells.first(cut), places, parts / 2, take);
  bisect(cells.subspan(cut), places, parts - parts / 2, take);
}

std::size_t part_count(std::size_t cells, std::size_t per_part) {
  return (cells + per_part - 1) / per_part;
}

struct Extent {
  std::array<int, 3> low, high;  // of the cells
  [[nodiscard]] std::size_t length(std::size_t axis) const {
    return static_cast<std::size_t>(high[axis] - low[axis] + 1);
  }
  [[nodiscard]] std::size_t volume() const { return length(0) * length(1) * length(2); }
};

Extent extent_of(std::span<const std::uint32_t> cells,
                 const std::vector<GridCell>& grid) {
  Extent extent{.low = grid[cells[0]].at, .high = grid[cells[0]].at};
  for (const std::uint32_t c : cells)
    for (std::size_t i = 0; i < 3; ++i) {
      extent.low[i] = std::min(extent.low[i], grid[c].at[i]);
      extent.high[i] = std::max(extent.high[i], grid[c].at[i]);
    }
  return extent;
}

/// Slots along the axes in turn, the longest last: it has the smallest layers.
Block grid_block(std::span<const std::uint32_t> cells,
                 const std::vector<GridCell>& grid) {
  const Extent extent = extent_of(cells, grid);
  std::size_t last = 2;
  for (std::size_t i = 0; i < 2; ++i)
    if (extent.length(i) > extent.length(last)) last = i;
  const std::array<std::size_t, 3> axes{(last + 1) % 3, (last + 2) % 3, last};  // cyclic
  Block block;
  block.row = extent.length(axes[0]) + 1;
  block.layer = block.row * (extent.length(axes[1]) + 1);
  const std::size_t slots = rounded_up(block.layer * (extent.length(axes[2]) + 1));
  block.nodes.assign(slots, no_node);
  block.cells.assign(slots, no_cell);
  const std::array<std::size_t, 3> step{1, block.row, block.layer};
  for (const std::uint32_t c : cells) {
    std::size_t slot = 0;
    for (std::size_t i = 0; i < 3; ++i)
      slot +=
          step[i] * static_cast<std::size_t>(grid[c].at[axes[i]] - extent.low[axes[i]]);
    block.cells[slot] = c;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      std::size_t node_slot = slot;
      for (std::size_t i = 0; i < 3; ++i)
        if ((corner >> axes[i] & 1U) != 0) node_slot += step[i];
      block.nodes[node_slot] = grid[c].corners[corner];
    }
  }
  return block;
}

Block free_block(std::span<const std::uint32_t> cells, const Mesh& mesh) {
  Block block;
  std::vector<std::pair<NodeIndex, std::uint32_t>> slots;
  for (const std::uint32_t c : cells)
    for (const NodeIndex node : mesh.cells()[c])
      slots.emplace_back(node, static_cast<std::uint32_t>(slots.size()));
  // Slots in the order in which the cells first name their nodes.
  std::ranges::sort(slots);
  slots.erase(
      std::ranges::unique(slots, {}, &std::pair<NodeIndex, std::uint32_t>::first).begin(),
      slots.end());
  std::ranges::sort(slots, {}, &std::pair<NodeIndex, std::uint32_t>::second);
  for (std::size_t s = 0; s < slots.size(); ++s) {
    block.nodes.push_back(slots[s].first);
    slots[s].second = static_cast<std::uint32_t>(s);
  }
  std::ranges::sort(slots);
  block.nodes.resize(rounded_up(block.nodes.size()), no_node);
  for (const std::uint32_t c : cells) {
    block.cells.push_back(c);
    std::array<std::uint32_t, 8> corners{};
    for (std::size_t corner = 0; corner < 8; ++corner)
      corners[corner] =
          std::ranges::lower_bound(slots, mesh.cells()[c][grid_corners[corner]], {},
                                   &std::pair<NodeIndex, std::uint32_t>::first)
              ->second;
    block.corners.push_back(corners);
  }
  block.cells.resize(rounded_up(block.cells.size()), no_cell);
  block.corners.resize(block.cells.size(), block.corners.back());
  return block;
}

}  // namespace

std::array<std::uint32_t, 8> Block::corner_slots(std::size_t cell) const {
  if (!is_grid()) return corners[cell];
  std::array<std::uint32_t, 8> slots{};
  for (std::size_t c = 0; c < 8; ++c)
    slots[c] = static_cast<std::uint32_t>(cell + (c & 1U) + row * (c >> 1U & 1U) +
                                          layer * (c >> 2U));
  return slots;
}

std::vector<Block> grid_blocks(const std::vector<GridCell>& grid) {
  std::vector<Place> places;
  std::uint32_t bodies = 0;
  for (const GridCell& cell : grid) {
    places.push_back({static_cast<double>(cell.at[0]), static_cast<double>(cell.at[1]),
                      static_cast<double>(cell.at[2])});
    bodies = std::max(bodies, cell.body + 1);
  }
  std::vector<std::vector<std::uint32_t>> cells_of(bodies);
  for (std::uint32_t c = 0; c < grid.size(); ++c) cells_of[grid[c].body].push_back(c);
  const std::size_t per_block = cells_per_block(grid.size());
  std::vector<Block> blocks;
  for (auto& cells : cells_of)
    bisect(std::span(cells), places, part_count(cells.size(), per_block),
           [&](std::span<std::uint32_t> part) {
             const bool is_sparse = extent_of(part, grid).volume() > 4 * part.size() &&
                                    part.size() > sparse_cells;
             bisect(part, places,
                    is_sparse ? part_count(part.size(), sparse_cells) : std::size_t{1},
                    [&](std::span<std::uint32_t> piece) {
                      blocks.push_back(grid_block(piece, grid));
                    });
           });
  return blocks;
}

std::vector<Block> free_blocks(const Mesh& mesh) {
  std::vector<Place> places;
  for (const CellNodes& cell : mesh.cells()) {
    const Vector3 centre = corners(cell, mesh.nodes()).rowwise().mean();
    places.push_back({centre.x(), centre.y(), centre.z()});
  }
  std::vector<std::uint32_t> cells(mesh.cells().size());
  std::iota(cells.begin(), cells.end(), 0U);
  // Down to a register's worth of cells: neighbours are worked on one after the other.
  std::vector<std::uint32_t> sorted;
  bisect(std::span(cells), places, part_count(cells.size(), block_granularity),
         [&](std::span<std::uint32_t> part) {
           sorted.insert(sorted.end(), part.begin(), part.end());
         });
  const std::size_t parts = part_count(cells.size(), cells_per_block(cells.size()));
  std::vector<Block> blocks;
  for (std::size_t p = 0; p < parts; ++p) {
    const std::size_t from = sorted.size() * p / parts,
                      to = sorted.size() * (p + 1) / parts;
    blocks.push_back(free_block(std::span(sorted).subspan(from, to - from), mesh));
  }
  return blocks;
}

Block whole_mesh(const Mesh& mesh) {
  Block block;
  block.nodes.resize(mesh.nodes().size());
  std::iota(block.nodes.begin(), block.nodes.end(), NodeIndex{0});
  block.nodes.resize(rounded_up(block.nodes.size()), no_node);
  return block;
}

}  // namespace springcheck::dynamics
