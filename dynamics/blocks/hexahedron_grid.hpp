#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck::dynamics {

/// The place of a hexahedron in a grid. Its corner x + 2 y + 4 z, with x, y and z each 0
/// or 1, stands at `at` + (x, y, z).
struct GridCell {
  std::array<int, 3> at;
  std::array<NodeIndex, 8> corners;
  std::uint32_t body;  // cells linked through faces have one number, and one grid
};

/// The mesh's cells as parts of regular grids, in the mesh's order: whatever their shapes
/// and however nodes and cells are numbered, neighbours through a face are neighbours in
/// the grid. Returns nothing where the cells are not all hexahedra, or where no such grid
/// exists: around some edge inside there are not four cells, or the grid closes on
/// itself.
std::optional<std::vector<GridCell>> grid_of(const Mesh& mesh);

}  // namespace springcheck::dynamics
