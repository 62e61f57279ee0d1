#include "fem_reference/statics/elements_body.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "statics/systems/positive_part.hpp"

namespace springcheck::fem_reference {

using Eigen::VectorXd;

ElementsBody::ElementsBody(const Discretisation& body, const CellLaw& law)
    : body_(body), law_(law) {}

double ElementsBody::cell_edge() const {
  double volume = 0;
  for (const Cell& cell : body_.cells) volume += cell.shape->volume;
  return std::cbrt(volume / static_cast<double>(body_.cells.size()));
}

bool ElementsBody::is_linear() const {
  return std::holds_alternative<Hooke>(law_.constitution);
}

statics::ElasticBody::State ElementsBody::state(const VectorXd& displacements) {
  const NodalPatchState nodal_patches = nodal_patch_state(law_, body_, displacements);
  State sum{.strain_energy = nodal_patches.energy,
            .forces = VectorXd::Zero(displacements.size())};
  std::vector<CellState> states(body_.cells.size());
  tbb::parallel_for(std::size_t{0}, states.size(), [&](std::size_t c) {
    const Cell& cell = body_.cells[c];
    states[c] = cell_state(law_, *cell.shape, of_cell(displacements, cell),
                           from_patches(nodal_patches, c));
  });
  for (std::size_t c = 0; c < states.size(); ++c) {
    const std::vector<NodeIndex>& nodes = body_.cells[c].nodes;
    sum.strain_energy += states[c].energy;
    if (!is_linear() && !(states[c].smallest_jacobian > 0))
      sum.strain_energy = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < nodes.size(); ++a)
      sum.forces.segment<3>(3 * Eigen::Index{nodes[a]}) -=
          states[c].forces.col(static_cast<Eigen::Index>(a));
  }
  return sum;
}

statics::Patches ElementsBody::patches() const {
  statics::Patches all = fem_reference::patches(body_);
  for (NodeIndex node = 0; node < body_.nodal_patches.size(); ++node)
    all.push_back(patch_nodes(body_, node));
  return all;
}

void ElementsBody::linearise(const VectorXd& displacements) {
  at_ = displacements;
  nodal_patches_ = nodal_patch_state(law_, body_, displacements);
}

Eigen::MatrixXd ElementsBody::part(std::size_t patch) const {
  if (patch >= body_.cells.size()) return matrix(nodal_patch(patch));
  const Cell& cell = body_.cells[patch];
  return cell_tangent(law_, *cell.shape, of_cell(at_, cell),
                      from_patches(nodal_patches_, patch));
}

Eigen::MatrixXd ElementsBody::positive_part(std::size_t patch) const {
  if (patch < body_.cells.size()) return statics::positive_part(part(patch));
  NodalPatchTangent tangent = nodal_patch(patch);
  tangent.shape = statics::positive_part(tangent.shape);
  tangent.volumetric = std::max(tangent.volumetric, 0.);
  return matrix(tangent);
}

NodalPatchTangent ElementsBody::nodal_patch(std::size_t patch) const {
  return patch_tangent(law_, body_, at_, nodal_patches_,
                       static_cast<NodeIndex>(patch - body_.cells.size()));
}

double ElementsBody::mean_gradient(const VectorXd& field) const {
  double squares = 0, volume = 0;
  for (const Cell& cell : body_.cells) {
    squares += gradient_square(*cell.shape, of_cell(field, cell));
    volume += cell.shape->volume;
  }
  return std::sqrt(squares / volume);
}

double ElementsBody::largest_volume_ratio(const VectorXd& displacements) const {
  const std::vector<double> volumes = cell_volumes(displacements);
  double largest = 0;
  for (std::size_t c = 0; c < volumes.size(); ++c)
    largest = std::max(largest, volumes[c] / body_.cells[c].shape->volume);
  return largest;
}

double ElementsBody::rounding(const VectorXd& displacements) const {
  return 10 * std::numeric_limits<double>::epsilon() *
         displacements.cwiseAbs().maxCoeff();
}

std::vector<double> ElementsBody::cell_volumes(const VectorXd& displacements) const {
  std::vector<double> volumes;
  for (const Cell& cell : body_.cells)
    volumes.push_back(deformed_volume(*cell.shape, of_cell(displacements, cell)));
  return volumes;
}

}  // namespace springcheck::fem_reference
