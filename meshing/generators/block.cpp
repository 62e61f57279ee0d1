#include "meshing/generators/block.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace springcheck {
namespace {

constexpr std::array<CellPatternName, 11> patterns{
    {{"hexahedron", CellPattern::hexahedron, "regular grid"},
     {"tetrahedron", CellPattern::tetrahedron, "six tetrahedra in each hexahedron"},
     {"prism", CellPattern::prism, "two prisms in each hexahedron"},
     {"pyramid", CellPattern::pyramid, "six pyramids in each hexahedron"},
     {"mixed", CellPattern::mixed, "all four types side by side on the grid"},
     {"tetrahedron-5", CellPattern::tetrahedron_5, "five tetrahedra in each hexahedron"},
     {"tetrahedron-12", CellPattern::tetrahedron_12,
      "twelve tetrahedra around the centre of each hexahedron"},
     {"free-tetrahedron", CellPattern::free_tetrahedron, "gmsh's Delaunay tetrahedra"},
     {"free-prism", CellPattern::free_prism, "gmsh's triangles, extruded along z"},
     {"free-hexahedron", CellPattern::free_hexahedron,
      "gmsh's tetrahedra, each cut into four hexahedra"},
     {"transition", CellPattern::transition,
      "hexahedra below, gmsh's tetrahedra above, pyramids between"}}};

}  // namespace

std::string_view name_of(CellPattern pattern) {
  return std::ranges::find(patterns, pattern, &CellPatternName::value)->name;
}

std::span<const CellPatternName> cell_patterns() {
  return patterns;
}

bool keeps_grid(CellPattern pattern) {
  switch (pattern) {
    case CellPattern::free_tetrahedron:
    case CellPattern::free_prism:
    case CellPattern::free_hexahedron:
    case CellPattern::transition:
      return false;
    default:
      return true;
  }
}

std::string describe(const Block& block) {
  std::string text = fmt::format("block {} m in {} cells", fmt::join(block.size, " x "),
                                 fmt::join(block.cells, " x "));
  if (block.pattern != CellPattern::hexahedron)
    text += fmt::format(", {}", name_of(block.pattern));
  if (block.distortion != 0) text += fmt::format(", distorted by {}", block.distortion);
  if (block.distortion != 0 || block.pattern == CellPattern::mixed)
    text += fmt::format(", seed {}", block.seed);
  return text;
}

}  // namespace springcheck
