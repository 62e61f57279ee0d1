#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace springcheck {

/// How a block is cut into cells. Those made from the grid of cells start with it:
///
///     hexahedron        the grid itself
///     prism             two in each hexahedron
///     pyramid           six, around its centre
///     tetrahedron       six, three in each of two prisms
///     tetrahedron_5     five, mirrored from one hexahedron to the next
///     tetrahedron_12    twelve, around its centre: two in each of six pyramids, and
///                       six in each of two prisms
///     mixed             hexahedra, pairs of prisms, and hexahedra cut around their
///                       centre into pyramids and tetrahedra, side by side as the seed
///                       says
///
/// Those that gmsh makes have about the same edge length:
///
///     free_tetrahedron  Delaunay tetrahedra
///     free_prism        free triangles, extruded along z
///     free_hexahedron   free tetrahedra at twice the edge, each cut into four hexahedra
///     transition        hexahedra below, free tetrahedra above, pyramids between them
///                       (at least three layers)
///
/// Source of the subdivisions: Golec 2018, section 6.1.
enum class CellPattern {
  hexahedron,
  tetrahedron,
  prism,
  pyramid,
  mixed,
  tetrahedron_5,
  tetrahedron_12,
  free_tetrahedron,
  free_prism,
  free_hexahedron,
  transition
};

struct CellPatternName {
  std::string_view name;  // on the command line
  CellPattern value;
  std::string_view description;
};
std::span<const CellPatternName> cell_patterns();
std::string_view name_of(CellPattern pattern);

/// A box with one corner at the origin, cut into a regular grid of cells, or into free
/// ones of about their size.
struct Block {
  std::array<double, 3> size;  // [m] along x, y, z
  std::array<int, 3> cells;    // along x, y, z
  CellPattern pattern = CellPattern::hexahedron;
  // Nodes inside the body move along each axis by up to this fraction of the grid's cell
  // edge there, centre nodes to the mean of their hexahedron's corners; those on the
  // surface stay, and with them plates, volume and tip:
  double distortion = 0;
  unsigned seed = 1;  // of the distortion and of the mixed pattern

  friend bool operator==(const Block&, const Block&) = default;
};

/// Whether the pattern keeps all nodes of the grid, with the grid's numbers.
bool keeps_grid(CellPattern pattern);

/// "block 0.05 x 0.05 x 0.05 m in 10 x 10 x 10 cells", and what else shapes its cells.
std::string describe(const Block& block);

}  // namespace springcheck
