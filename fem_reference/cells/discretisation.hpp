#pragma once

#include <map>
#include <string>
#include <vector>

#include "fem_reference/cells/cell.hpp"
#include "meshing/mesh.hpp"
#include "meshing/nodal_patches.hpp"

namespace springcheck::fem_reference {

/// A node's part of a face's area, int N dA [m^2].
struct AreaShare {
  NodeIndex node;
  double area;
};

/// The mesh's cells, in its order, with the shape functions of an element. Nodes
/// 0..vertices-1 are the mesh's; q2 adds intermediate nodes behind them. The geometry of
/// all elements is that of the mesh: straight edges, bilinear quadrilaterals.
struct Discretisation {
  std::size_t vertices;
  std::vector<Vector3> nodes;  // [m]
  // Vertices whose mean an intermediate node is, ascending: two, four or eight.
  std::vector<std::vector<NodeIndex>> parents{};
  std::vector<Cell> cells;
  std::map<std::string, std::vector<AreaShare>> regions{};
  NodalPatches nodal_patches{},
      tetrahedron_patches{};  // of q1_nodal: of all cells, of tetrahedra alone
};

/// q2 is for meshes of hexahedra only.
Discretisation discretise(const Mesh& mesh, Element element);

/// Nodes of each cell.
std::vector<std::vector<NodeIndex>> patches(const Discretisation& body);

/// The values of one cell's nodes in a nodal vector, dof = 3 node + component.
CellVectors of_cell(const Eigen::VectorXd& nodal, const Cell& cell);

}  // namespace springcheck::fem_reference
