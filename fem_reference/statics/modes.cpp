#include "fem_reference/statics/modes.hpp"

#include "fem_reference/statics/elements_body.hpp"
#include "fem_reference/statics/supports.hpp"
#include "statics/systems/free_triangle.hpp"

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
  ElementsBody elements(body, {.constitution = constitution(scene.material, settings),
                               .dilatation = dilatation_taken(settings)});
  elements.linearise(Eigen::VectorXd::Zero(3 * std::ssize(body.nodes)));
  const statics::Unknowns unknowns(supports.is_free());
  const auto of_unknowns = [&](statics::Patches patches, const auto& part) {
    statics::BlockMatrix matrix(std::move(patches), body.nodes.size());
    matrix.assemble(part);
    return statics::FreeTriangle(matrix, unknowns).copy_of(matrix);
  };
  auto modes = natural_modes(
      of_unknowns(elements.patches(), [&](std::size_t p) { return elements.part(p); }),
      of_unknowns(patches(body),
                  [&](std::size_t c) {
                    return cell_mass(*body.cells[c].shape, scene.material.density, mass);
                  }),
      count);
  if (!modes) return std::nullopt;
  Eigen::MatrixXd of_all =
      Eigen::MatrixXd::Zero(3 * std::ssize(body.nodes), modes->shapes.cols());
  of_all(unknowns.components(), Eigen::all) = modes->shapes;
  modes->shapes = std::move(of_all);
  return modes;
}

}  // namespace springcheck::fem_reference
