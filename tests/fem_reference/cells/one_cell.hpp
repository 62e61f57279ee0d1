#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "fem_reference/cells/cell.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"

namespace springcheck::fem_reference {

inline constexpr std::array places{DilatationTaken::at_points, DilatationTaken::cell_mean,
                                   DilatationTaken::of_mean_gradient};
inline constexpr double volume = edge * edge * edge;

inline CellLaw cell_law(Law law, DilatationTaken taken, double nu = 0.3) {
  return {.constitution =
              constitution(of_poisson_ratio(nu), {.law = law, .element = Element::q1}),
          .dilatation = taken};
}

/// A mesh's only cell, with a field at its nodes.
struct OneCell {
  OneCell(const Mesh& mesh, Element element) : body(discretise(mesh, element)) {}
  [[nodiscard]] const Shape& shape() const { return *body.cells.front().shape; }
  [[nodiscard]] CellVectors at_nodes(const Eigen::VectorXd& nodal_field) const {
    return of_cell(nodal_field, body.cells.front());
  }
  [[nodiscard]] CellVectors at_nodes(
      const std::function<Vector3(const Vector3&)>& field) const {
    return at_nodes(nodal(body, field));
  }
  Discretisation body;
};

/// Nodes of a cell of no symmetry, with edges of about `edge` [m].
inline std::vector<Vector3> corners_of_distorted(CellType type) {
  std::vector<Vector3> x{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  switch (type) {
    case CellType::tetrahedron:
      x = {{0, 0, 0}, {1, 0, 0}, {0.5, 0.9, 0}, {0.5, 0.3, 0.8}};
      break;
    case CellType::pyramid:
      x.emplace_back(0.5, 0.5, 0.7);
      break;
    case CellType::prism:
      x = {{0, 0, 0}, {1, 0, 0}, {0.5, 0.9, 0}, {0, 0, 1}, {1, 0, 1}, {0.5, 0.9, 1}};
      break;
    case CellType::hexahedron:
      for (int corner = 0; corner < 4; ++corner)
        x.push_back(x[static_cast<std::size_t>(corner)] + Vector3::UnitZ());
      break;
  }
  RandomVectors moved(0.15, 7);
  for (Vector3& corner : x) corner = edge * (corner + moved());
  return x;
}

inline Mesh mesh_of(const std::vector<Vector3>& nodes, const CellNodes& cell) {
  return {"one cell", nodes, {cell}, {}};
}

inline Mesh distorted_cell(CellType type) {
  CellNodes cell;
  for (NodeIndex node = 0; node < node_count(type); ++node) cell.push_back(node);
  return mesh_of(corners_of_distorted(type), cell);
}

}  // namespace springcheck::fem_reference
