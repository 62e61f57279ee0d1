#include "fem_reference/statics/modes.hpp"

#include "fem_reference/statics/stiffness_matrix.hpp"
#include "fem_reference/statics/supports.hpp"

namespace springcheck::fem_reference {
namespace {

/// int N_a N_b dV of a cell [m^3], exact on undistorted cells. A tetrahedron's one point
/// cannot tell its nodes apart; its integral is V (1 + delta_ab)/20, in closed form
/// (Zienkiewicz and Taylor, The Finite Element Method I (2000), Eq. 8.38).
Eigen::MatrixXd products(const Shape& shape) {
  if (shape.nodes == 4)
    return shape.volume / 20 *
           (Eigen::MatrixXd::Ones(4, 4) + Eigen::MatrixXd::Identity(4, 4));
  return shape.values->transpose() * shape.weights.asDiagonal() * *shape.values;
}

CellMatrix cell_mass(const Shape& shape, double density, MassMatrix kind) {
  Eigen::MatrixXd masses = density * products(shape);
  if (kind == MassMatrix::lumped)
    masses = masses.rowwise().sum().eval().asDiagonal().toDenseMatrix();
  CellMatrix blocks = CellMatrix::Zero(3 * shape.nodes, 3 * shape.nodes);
  for (Eigen::Index a = 0; a < shape.nodes; ++a)
    for (Eigen::Index b = 0; b < shape.nodes; ++b)
      blocks.block<3, 3>(3 * a, 3 * b).diagonal().setConstant(masses(a, b));
  return blocks;
}

}  // namespace

std::optional<NaturalModes> rest_modes(const Mesh& mesh, const Scene& scene,
                                       const Settings& settings, MassMatrix mass,
                                       int count) {
  const Discretisation body = discretise(mesh, settings.element);
  const Supports supports(mesh, scene, body);
  const CellLaw law{.constitution = constitution(scene.material, settings),
                    .dilatation = dilatation_taken(settings)};
  StiffnessMatrix stiffness(body, supports.prescribed());
  StiffnessMatrix masses(body, supports.prescribed());  // of the same pattern
  stiffness.clear();
  masses.clear();
  for (const Cell& cell : body.cells) {
    const CellVectors rest = CellVectors::Zero(3, cell.shape->nodes);
    stiffness.add(cell, cell_tangent(law, *cell.shape, rest));
    masses.add(cell, cell_mass(*cell.shape, scene.material.density, mass));
  }
  stiffness.finish();  // prescribed dofs: stiff, and without mass
  return natural_modes(stiffness.matrix(), masses.matrix(), count);
}

}  // namespace springcheck::fem_reference
