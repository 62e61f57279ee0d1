#include "meshing/generators/free_block.hpp"

#include <gmsh.h>

#include <cmath>
#include <stdexcept>

#include "meshing/generators/distortion.hpp"
#include "meshing/generators/transition_block.hpp"
#include "meshing/generators/z_curve.hpp"
#include "meshing/gmsh/algorithms.hpp"
#include "meshing/gmsh/box.hpp"
#include "meshing/gmsh/cells.hpp"
#include "meshing/gmsh/session.hpp"

namespace springcheck {
namespace {

/// The length to ask of gmsh's tetrahedra over that of the mean edge: left alone, edges
/// are 1.12 to 1.29 times as long as asked, 4 to 16 of them across a cube.
constexpr double delaunay_length = 0.85;

MeshParts by_gmsh(const Block& block) {
  namespace geo = ::gmsh::model::geo;
  const GmshSession session("block");
  const GmshBottom bottom = add_bottom(block.size[0], block.size[1], 0);
  const bool is_prism = block.pattern == CellPattern::free_prism;
  const std::vector<int> layers =
      is_prism ? std::vector{block.cells[2]} : std::vector<int>{};
  ::gmsh::vectorpair above;
  geo::extrude({{2, bottom.surface}}, 0, 0, block.size[2], above, layers, {}, is_prism);
  geo::synchronize();
  const Vector3 cell(block.size[0] / block.cells[0], block.size[1] / block.cells[1],
                     block.size[2] / block.cells[2]);
  if (block.pattern == CellPattern::free_hexahedron)
    generate_hexahedra(cell.mean());
  else
    generate_tetrahedra(is_prism ? cell.head<2>().mean() : delaunay_length * cell.mean());
  return gmsh_cells();
}

/// gmsh leaves nodes of a side off it by rounding.
void snap_to_sides(const Block& block, std::vector<Vector3>& nodes) {
  for (Vector3& x : nodes)
    for (std::size_t i = 0; i < 3; ++i) {
      double& coordinate = x[static_cast<Eigen::Index>(i)];
      for (const double side : {0., block.size[i]})
        if (std::abs(coordinate - side) < 1e-9 * block.size[i]) coordinate = side;
    }
}

}  // namespace

MeshParts free_block(const Block& block) try {
  MeshParts parts =
      block.pattern == CellPattern::transition ? transition_block(block) : by_gmsh(block);
  snap_to_sides(block, parts.nodes);
  distort(block, parts.nodes);
  return along_z_curve(parts);
} catch (const std::string& message) {  // what gmsh throws
  throw std::runtime_error("gmsh: " + message);
}

}  // namespace springcheck
