#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "meshing/mesh.hpp"

namespace springcheck {

/// A box with one corner at the origin, cut into a regular grid of cells.
struct BlockSize {
  std::array<double, 3> size;  // [m] along x, y, z
  std::array<int, 3> cells;    // along x, y, z
};

/// Hexahedral mesh of the block by gmsh's transfinite algorithm, with the regions
/// bottom (z = 0), top (z = height), x_min, x_max, y_min, y_max. Nodes are numbered
/// lexicographically, x fastest, and stand exactly on the grid (gmsh leaves them
/// about 1e-10 of a cell off it); cells are ordered likewise.
///
/// Throws InputError for sizes that are not positive and finite, fewer than one cell
/// along an axis, and more nodes than NodeIndex counts; and when the total volume is
/// not the box's.
Mesh generate_block(const BlockSize& block);

/// Version of the gmsh library in use, such as "4.8.4".
std::string gmsh_version();

/// Writes nodes, cells and named regions as gmsh .msh 4.1 (ASCII); node and cell tags
/// are our indices plus one. Throws std::runtime_error when not all could be written.
void write_msh(const Mesh& mesh, const std::filesystem::path& file);

}  // namespace springcheck
