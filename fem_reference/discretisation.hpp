#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "fem_reference/cell.hpp"
#include "meshing/mesh.hpp"

namespace springcheck::fem_reference {

/// A node's part of a face's area, int N dA [m^2].
struct AreaShare {
  NodeIndex node;
  double area;
};

/// The mesh's cells with the shape functions of an element. Nodes 0..vertices-1 are the
/// mesh's; q2 adds intermediate nodes behind them. The geometry of all elements is the
/// trilinear one of the mesh.
struct Discretisation {
  std::size_t vertices;
  std::vector<Vector3> nodes;  // [m]
  // Vertices whose mean an intermediate node is, ascending: two, four or eight.
  std::vector<std::vector<NodeIndex>> parents;
  std::vector<Cell> cells;
  Eigen::MatrixXd shape_values;  // N_a(point q) as (q, a), the same in every cell
  std::map<std::string, std::vector<AreaShare>> regions;
};

Discretisation discretise(const Mesh& mesh, Element element);

/// Consistent nodal forces of a body force density [N/m^3]: int N_a f dV [N].
Eigen::VectorXd body_load(const Discretisation& body,
                          const std::function<Vector3(const Vector3&)>& density);

/// Consistent nodal forces of a uniform dead stress [Pa] on a region [N].
Eigen::VectorXd traction_load(const Discretisation& body, const Traction& traction);

/// int u dA/A over a region [m].
Vector3 mean_displacement(const Discretisation& body, const std::string& region,
                          const Eigen::VectorXd& displacements);

/// The values of one cell's nodes in a nodal vector, dof = 3 node + component.
CellVectors of_cell(const Eigen::VectorXd& nodal, const Cell& cell);

}  // namespace springcheck::fem_reference
