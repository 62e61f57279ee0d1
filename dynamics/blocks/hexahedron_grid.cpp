#include "dynamics/blocks/hexahedron_grid.hpp"

#include <algorithm>
#include <queue>
#include <utility>

namespace springcheck::dynamics {
namespace {

constexpr std::uint32_t no_body = ~std::uint32_t{0};

/// The cell beyond each face of each cell; at the boundary it is the cell itself.
std::vector<std::array<std::uint32_t, 6>> neighbours_of(const Mesh& mesh) {
  struct Side {
    std::array<NodeIndex, 4> nodes;  // ascending
    std::uint32_t cell;
    std::uint8_t face;
  };
  std::vector<Side> sides;
  sides.reserve(6 * mesh.cells().size());
  std::vector<std::array<std::uint32_t, 6>> neighbours(mesh.cells().size());
  const auto local = faces(CellType::hexahedron);
  for (std::uint32_t c = 0; c < mesh.cells().size(); ++c)
    for (std::uint8_t f = 0; f < 6; ++f) {
      neighbours[c][f] = c;
      std::array<NodeIndex, 4> nodes{};
      std::ranges::copy(face_nodes(mesh.cells()[c], local[f]), nodes.begin());
      std::ranges::sort(nodes);
      sides.push_back({.nodes = nodes, .cell = c, .face = f});
    }
  std::ranges::sort(sides, {}, &Side::nodes);
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].nodes == sides[i - 1].nodes) {
      neighbours[sides[i].cell][sides[i].face] = sides[i - 1].cell;
      neighbours[sides[i - 1].cell][sides[i - 1].face] = sides[i].cell;
    }
  return neighbours;
}

bool has(const FaceNodes& face, NodeIndex node) {
  return std::ranges::find(face, node) != face.end();
}

/// The nodes of `cell` ordered so that its corners at `side` (0 or 1) along `axis` are
/// those of `from` at the other side, node by node.
std::array<NodeIndex, 8> aligned(const CellNodes& cell, const GridCell& from, int axis,
                                 int side) {
  const int bit = 1 << axis;
  std::array<NodeIndex, 8> corners{};
  FaceNodes shared;
  for (int c = 0; c < 8; ++c)
    if (((c & bit) != 0) == (side == 1)) {
      corners[static_cast<std::size_t>(c)] =
          from.corners[static_cast<std::size_t>(c ^ bit)];
      shared.push_back(corners[static_cast<std::size_t>(c)]);
    }
  for (const LocalEdge& edge : edges(CellType::hexahedron))
    for (const auto& [near, far] :
         {std::pair(edge[0], edge[1]), std::pair(edge[1], edge[0])})
      if (has(shared, cell[near]) && !has(shared, cell[far]))
        for (int c = 0; c < 8; ++c)
          if (((c & bit) != 0) == (side == 1) &&
              corners[static_cast<std::size_t>(c)] == cell[near])
            corners[static_cast<std::size_t>(c ^ bit)] = cell[far];
  return corners;
}

/// Whether every place of a body's grid has one node, and every node of it one place.
bool is_one_to_one(const std::vector<GridCell>& cells) {
  using Place = std::pair<std::uint32_t, std::array<int, 3>>;
  std::vector<std::pair<Place, NodeIndex>> nodes;
  nodes.reserve(8 * cells.size());
  for (const GridCell& cell : cells)
    for (int c = 0; c < 8; ++c)
      nodes.push_back(
          {{cell.body,
            {cell.at[0] + (c & 1), cell.at[1] + (c >> 1 & 1), cell.at[2] + (c >> 2)}},
           cell.corners[static_cast<std::size_t>(c)]});
  std::ranges::sort(nodes);
  nodes.erase(std::ranges::unique(nodes).begin(), nodes.end());
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (nodes[i].first == nodes[i - 1].first) return false;
  const auto by_node = [](const auto& entry) {
    return std::pair(entry.first.first, entry.second);
  };
  std::ranges::sort(nodes, {}, by_node);
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (by_node(nodes[i]) == by_node(nodes[i - 1])) return false;
  return true;
}

}  // namespace

std::optional<std::vector<GridCell>> grid_of(const Mesh& mesh) {
  if (mesh.count(CellType::hexahedron) != mesh.cells().size()) return std::nullopt;
  const auto neighbours = neighbours_of(mesh);
  const auto local = faces(CellType::hexahedron);
  std::vector<GridCell> grid(mesh.cells().size(),
                             {.at = {}, .corners = {}, .body = no_body});
  std::uint32_t bodies = 0;
  for (std::uint32_t first = 0; first < grid.size(); ++first) {
    if (grid[first].body != no_body) continue;
    grid[first].body = bodies++;
    for (std::size_t c = 0; c < 8; ++c)
      grid[first].corners[c] = mesh.cells()[first][grid_corners[c]];
    std::queue<std::uint32_t> front({first});
    while (!front.empty()) {
      const GridCell here = grid[front.front()];
      const CellNodes& nodes = mesh.cells()[front.front()];
      const auto& beyond = neighbours[front.front()];
      for (std::size_t f = 0; f < 6; ++f) {
        if (beyond[f] == front.front()) continue;
        const FaceNodes face = face_nodes(nodes, local[f]);
        for (int axis = 0; axis < 3; ++axis)
          for (int side = 0; side < 2; ++side) {
            bool is_this = true;
            for (int c = 0; c < 8; ++c)
              if ((c >> axis & 1) == side)
                is_this = is_this && has(face, here.corners[static_cast<std::size_t>(c)]);
            if (!is_this) continue;
            GridCell next{
                .at = here.at,
                .corners = aligned(mesh.cells()[beyond[f]], here, axis, 1 - side),
                .body = here.body};
            next.at[static_cast<std::size_t>(axis)] += side == 1 ? 1 : -1;
            GridCell& found = grid[beyond[f]];
            if (found.body == no_body) {
              found = next;
              front.push(beyond[f]);
            } else if (found.at != next.at || found.corners != next.corners) {
              return std::nullopt;
            }
          }
      }
      front.pop();
    }
  }
  if (!is_one_to_one(grid)) return std::nullopt;
  return grid;
}

}  // namespace springcheck::dynamics
