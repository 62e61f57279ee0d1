#include "mss/networks/cell_springs.hpp"

#include <bit>
#include <cassert>

namespace springcheck::mss {
namespace {

/// The directions, as bits, in which two corners of a hexahedron differ.
unsigned differing_directions(const LocalEdge& pair) {
  // In a grid's order corner i is at (x, y, z) of the unit cube, one bit each; and the
  // order is its own inverse.
  return unsigned{grid_corners[pair[0]]} ^ grid_corners[pair[1]];
}

}  // namespace

std::vector<LocalEdge> face_diagonals(CellType type) {
  std::vector<LocalEdge> diagonals;
  for (const LocalFace& face : faces(type)) {
    if (face.size() != 4) continue;
    diagonals.push_back({face[0], face[2]});
    diagonals.push_back({face[1], face[3]});
  }
  return diagonals;
}

std::vector<LocalEdge> inner_diagonals(CellType type) {
  if (type != CellType::hexahedron) return {};
  return {{0, 6}, {1, 7}, {2, 4}, {3, 5}};
}

std::size_t edge_direction(const LocalEdge& edge) {
  const unsigned along = differing_directions(edge);
  assert(std::popcount(along) == 1);
  return static_cast<std::size_t>(std::countr_zero(along));
}

std::size_t face_direction(const LocalEdge& diagonal) {
  const unsigned across = 7U ^ differing_directions(diagonal);
  assert(std::popcount(across) == 1);
  return static_cast<std::size_t>(std::countr_zero(across));
}

}  // namespace springcheck::mss
