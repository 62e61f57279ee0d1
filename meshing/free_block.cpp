#include "meshing/free_block.hpp"

#include <gmsh.h>

#include <cmath>
#include <stdexcept>

#include "meshing/distortion.hpp"
#include "meshing/gmsh_box.hpp"
#include "meshing/gmsh_cells.hpp"
#include "meshing/gmsh_session.hpp"
#include "meshing/transition_block.hpp"
#include "meshing/z_curve.hpp"

namespace springcheck {
namespace {

void add_geometry(const Block& block) {
  namespace geo = ::gmsh::model::geo;
  const Vector3 cell(block.size[0] / block.cells[0], block.size[1] / block.cells[1],
                     block.size[2] / block.cells[2]);
  set_edge_length(cell.mean());
  const GmshBottom bottom = add_bottom(block.size[0], block.size[1], 0);
  ::gmsh::vectorpair above;
  if (block.pattern == CellPattern::free_prism) {
    set_edge_length(cell.head<2>().mean());
    geo::extrude({{2, bottom.surface}}, 0, 0, block.size[2], above, {block.cells[2]}, {},
                 true);
    return;
  }
  geo::extrude({{2, bottom.surface}}, 0, 0, block.size[2], above);
  if (block.pattern == CellPattern::free_hexahedron) {
    set_edge_length(2 * cell.mean());
    ::gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 2);  // all hexahedra
  }
}

MeshParts by_gmsh(const Block& block) {
  const GmshSession session("block");
  add_geometry(block);
  generate_mesh();
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
