#include "meshing/generators/transition_block.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>

#include "meshing/generators/grid_block.hpp"
#include "meshing/generators/hexahedron_cuts.hpp"
#include "meshing/gmsh/algorithms.hpp"
#include "meshing/gmsh/box.hpp"
#include "meshing/gmsh/cells.hpp"
#include "meshing/gmsh/session.hpp"

namespace springcheck {
namespace {

/// Hexahedra, the uppermost layer of them cut around the centres.
MeshParts lower_zone(const Block& hexahedra) {
  MeshParts parts = grid_block(hexahedra);
  const auto layer = static_cast<std::size_t>(hexahedra.cells[0]) *
                     static_cast<std::size_t>(hexahedra.cells[1]);
  const auto first = parts.cells.end() - static_cast<std::ptrdiff_t>(layer);
  const std::vector<CellNodes> uppermost(first, parts.cells.end());
  parts.cells.erase(first, parts.cells.end());
  for (const CellNodes& hexahedron : uppermost) {
    const auto centre = static_cast<NodeIndex>(parts.nodes.size());
    parts.nodes.push_back(mean_of(hexahedron, parts.nodes));
    const std::vector<CellNodes> around =
        cells_around(centre, hexahedron, {false, true, true, true, true, true});
    parts.cells.insert(parts.cells.end(), around.begin(), around.end());
  }
  return parts;
}

/// Tetrahedra from z up, whose triangles there are halves of the grid's rectangles.
MeshParts upper_zone(const Block& block, double z, double edge_length) {
  namespace geo = ::gmsh::model::geo;
  const GmshSession session("transition");
  const GmshBottom bottom = add_bottom(block.size[0], block.size[1], z);
  for (std::size_t i = 0; i < 4; ++i)
    geo::mesh::setTransfiniteCurve(bottom.edges[i], block.cells[i % 2] + 1);
  geo::mesh::setTransfiniteSurface(bottom.surface, "Right");  // as cells_around cuts
  ::gmsh::vectorpair above;
  geo::extrude({{2, bottom.surface}}, 0, 0, block.size[2] - z, above);
  geo::synchronize();
  generate_tetrahedra(edge_length);
  return gmsh_cells();
}

/// Adds the upper zone, whose nodes at z are the last of the hexahedra's grid.
void add_zone(const MeshParts& upper, const Block& hexahedra, MeshParts& parts) {
  const double z = hexahedra.size[2];
  const auto [along_x, along_y, layers] = hexahedra.cells;
  const auto first_at_z = (along_x + 1) * (along_y + 1) * layers;
  std::vector<NodeIndex> number;
  for (const Vector3& x : upper.nodes) {
    if (std::abs(x.z() - z) < 1e-9 * z) {
      const long i = std::lround(x.x() / hexahedra.size[0] * along_x),
                 j = std::lround(x.y() / hexahedra.size[1] * along_y);
      number.push_back(static_cast<NodeIndex>(first_at_z + i + (along_x + 1) * j));
    } else {
      number.push_back(static_cast<NodeIndex>(parts.nodes.size()));
      parts.nodes.push_back(x);
    }
  }
  for (const CellNodes& cell : upper.cells) {
    parts.cells.emplace_back();
    for (const NodeIndex node : cell) parts.cells.back().push_back(number[node]);
  }
}

}  // namespace

MeshParts transition_block(const Block& block) {
  const int layers = std::max(3, block.cells[2]), lower = (layers + 1) / 2;
  const double height = block.size[2] / layers;
  const Block hexahedra{.size = {block.size[0], block.size[1], height * lower},
                        .cells = {block.cells[0], block.cells[1], lower}};
  MeshParts parts = lower_zone(hexahedra);
  const double edge_length =
      (block.size[0] / block.cells[0] + block.size[1] / block.cells[1] + height) / 3;
  add_zone(upper_zone(block, hexahedra.size[2], edge_length), hexahedra, parts);
  return parts;
}

}  // namespace springcheck
