#include "mss/forces/tangent.hpp"

#include <algorithm>

#include "statics/systems/positive_part.hpp"

namespace springcheck::mss {
namespace {

Eigen::Index row(std::size_t node) {
  return static_cast<Eigen::Index>(3 * node);
}

/// D of a patch: 9 rows, 3 columns per node.
template <class Gradients>
Eigen::Matrix<double, 9, Eigen::Dynamic> gradient_matrix(const Gradients& gradients,
                                                         std::size_t nodes) {
  Eigen::Matrix<double, 9, Eigen::Dynamic> D =
      Eigen::Matrix<double, 9, Eigen::Dynamic>::Zero(9, row(nodes));
  for (std::size_t a = 0; a < nodes; ++a)
    for (Eigen::Index J = 0; J < 3; ++J)
      D.block<3, 3>(3 * J, row(a)).diagonal().setConstant(gradients(a)[J]);
  return D;
}

void add_constant_springs(Eigen::MatrixXd& tangent, const Network& network,
                          std::size_t cell, std::span<const Vector3> positions) {
  const auto nodes = network.cells.nodes(cell);
  for (const auto& [ends, stiffness, rest] : network.cells.springs(cell)) {
    const Vector3 d = positions[nodes[ends[1]]] - positions[nodes[ends[0]]];
    const double length = d.norm();
    if (length == 0) continue;
    const Vector3 n = d / length;
    const auto [across, along] = spring_pull(network.strain_measure, rest.norm(), length);
    add_between(tangent, ends,
                stiffness * (across * Matrix3::Identity() +
                             (along - across) * n * n.transpose()));
  }
}

/// k [q q^T + e d2e] with q the gradient of the elongation e, the difference of a
/// function of |d| and the same of |F r|; what is of |F r| in d2e goes by way of F, into
/// the matrix `by_gradient`.
void add_affine_springs(Eigen::MatrixXd& tangent, Matrix9& by_gradient,
                        const Network& network, const CellStates& states,
                        std::size_t cell) {
  const auto gradients = network.cells.gradients(cell);
  Eigen::MatrixXd q(tangent.rows(), network.cells.springs(cell).size());
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(q.cols());
  q.setZero();
  Eigen::Index column = 0;
  for_each_affine_spring(
      network, states, cell, [&](const CellSpring& spring, const AffineSpring& now) {
        const double k = spring.stiffness, e = now.elongation;
        const Vector3 n = now.d / now.length, m = now.rest / now.rest_length,
                      &r = spring.rest;
        const ElongationSlopes own = elongation_slopes(network.strain_measure, now.unit,
                                                       now.length),
                               affine = elongation_slopes(network.strain_measure,
                                                          now.unit, now.rest_length);
        const Vector3 pull = own.first * n;
        q.block<3, 1>(row(spring.ends[0]), column) = -pull;
        q.block<3, 1>(row(spring.ends[1]), column) = pull;
        for (std::size_t a = 0; a < gradients.size(); ++a)
          q.block<3, 1>(row(a), column) -= gradients[a].dot(r) * affine.first * m;
        weights[column++] = k;
        const auto curvature = [&](const ElongationSlopes& slopes, double length,
                                   const Vector3& along) -> Matrix3 {
          const Matrix3 projector = along * along.transpose();
          return k * e * slopes.first / length * (Matrix3::Identity() - projector) +
                 k * e * slopes.second * projector;
        };
        add_between(tangent, spring.ends, curvature(own, now.length, n));
        const Matrix3 across = curvature(affine, now.rest_length, m);
        for (Eigen::Index J = 0; J < 3; ++J)
          for (Eigen::Index L = 0; L < 3; ++L)
            by_gradient.block<3, 3>(3 * J, 3 * L) -= r[J] * r[L] * across;
      });
  tangent += q * weights.asDiagonal() * q.transpose();
}

Eigen::MatrixXd cell_tangent(const Tangent& at, std::size_t cell) {
  const Network& network = *at.network;
  const CellStates& states = at.states;
  const auto gradients = network.cells.gradients(cell);
  Eigen::MatrixXd tangent =
      Eigen::MatrixXd::Zero(row(gradients.size()), row(gradients.size()));
  if (network.cell_springs == RestLength::constant)
    add_constant_springs(tangent, network, cell, at.positions);
  if (!cells_act(network)) return tangent;

  const Matrix3& H = states.displacement_gradients[cell];
  const double V = network.cells.volume(cell);
  Matrix9 by_gradient = own_part(network, cell) * V * law_of(network).tangent(H);
  if (!states.patch_pressures.empty())
    by_gradient += V * patch_pressure(network, states, cell) *
                   volume_hessian(network.strain_measure, H);
  if (network.cell_springs == RestLength::affine)
    add_affine_springs(tangent, by_gradient, network, states, cell);
  const auto D =
      gradient_matrix([&](std::size_t a) { return gradients[a]; }, gradients.size());
  tangent += D.transpose() * by_gradient * D;
  return tangent;
}

std::vector<NodeIndex> patch_nodes(const Network& network, std::size_t nodal_patch) {
  const NodalPatches& all =  // those of volume have all cells
      network.volume_patches.size() > 0 ? network.volume_patches : network.shape_patches;
  return nodes_of_patch(all[nodal_patch],
                        [&](NodeIndex cell) { return network.cells.nodes(cell); });
}

/// What part() says of a nodal patch.
struct NodalPatchTangent {
  std::vector<NodeIndex> nodes;
  Eigen::Matrix3Xd gradients{};         // G_a [1/m]
  Matrix9 shape;                        // 3/4 V_n dP/dF [J]
  Eigen::Matrix3Xd volume_gradients{};  // g_a [1/m]
  double volume;                        // V_n U''(t_n) [J]
};

Eigen::MatrixXd matrix(const NodalPatchTangent& nodal_patch) {
  const auto D = gradient_matrix(
      [&](std::size_t a) {
        return nodal_patch.gradients.col(static_cast<Eigen::Index>(a));
      },
      nodal_patch.nodes.size());
  const auto v = nodal_patch.volume_gradients.reshaped();
  Eigen::MatrixXd sum = nodal_patch.volume * v * v.transpose();
  if (!nodal_patch.shape.isZero(0)) sum += D.transpose() * nodal_patch.shape * D;
  return sum;
}

/// Adds weight * (map G_a) to the column of each of a cell's nodes a.
void add_gradients(Eigen::Matrix3Xd& columns, const std::vector<NodeIndex>& nodes,
                   const Cells& cells, const NodalPatches::Part& part,
                   const Matrix3& map) {
  const auto at = cells.nodes(part.cell);
  for (std::size_t a = 0; a < at.size(); ++a) {
    const auto column = std::ranges::lower_bound(nodes, at[a]) - nodes.begin();
    columns.col(column) += part.weight * map * cells.gradients(part.cell)[a];
  }
}

NodalPatchTangent patch_tangent(const Tangent& at, std::size_t nodal_patch) {
  const Network& network = *at.network;
  const CellStates& states = at.states;
  NodalPatchTangent tangent{
      .nodes = patch_nodes(network, nodal_patch), .shape = Matrix9::Zero(), .volume = 0};
  const auto count = static_cast<Eigen::Index>(tangent.nodes.size());
  tangent.gradients.setZero(3, count);
  tangent.volume_gradients.setZero(3, count);
  if (network.shape_patches.size() > 0 && !network.shape_patches[nodal_patch].empty()) {
    for (const NodalPatches::Part& part : network.shape_patches[nodal_patch])
      add_gradients(tangent.gradients, tangent.nodes, network.cells, part,
                    Matrix3::Identity());
    tangent.shape = patch_part * network.shape_patches.volumes[nodal_patch] *
                    law_of(network).tangent(states.patch_gradients[nodal_patch]);
  }
  if (network.volume_patches.size() > 0) {
    for (const NodalPatches::Part& part : network.volume_patches[nodal_patch])
      add_gradients(tangent.volume_gradients, tangent.nodes, network.cells, part,
                    volume_gradient(network.strain_measure,
                                    states.displacement_gradients[part.cell]));
    const VolumePull pull = volume_pull(network.strain_measure, network.volume_moduli,
                                        states.patch_volume_changes[nodal_patch]);
    tangent.volume =
        pull.modulus * pull.second * network.volume_patches.volumes[nodal_patch];
  }
  return tangent;
}

std::size_t patch_count(const Network& network) {
  return std::max(network.shape_patches.size(), network.volume_patches.size());
}

}  // namespace

void add_between(Eigen::MatrixXd& tangent, const LocalEdge& ends, const Matrix3& block) {
  const Eigen::Index i = row(ends[0]), j = row(ends[1]);
  tangent.block<3, 3>(i, i) += block;
  tangent.block<3, 3>(j, j) += block;
  tangent.block<3, 3>(i, j) -= block;
  tangent.block<3, 3>(j, i) -= block;
}

Tangent tangent_at(const Network& network, std::span<const Vector3> positions) {
  Tangent tangent{.network = &network,
                  .positions = {positions.begin(), positions.end()},
                  .states = {}};
  if (cells_act(network)) update_deformations(network, positions, tangent.states);
  return tangent;
}

std::vector<std::vector<NodeIndex>> patches(const Network& network) {
  std::vector<std::vector<NodeIndex>> all;
  for (std::size_t c = 0; c < network.cells.size(); ++c) {
    const auto nodes = network.cells.nodes(c);
    all.emplace_back(nodes.begin(), nodes.end());
  }
  for (std::size_t n = 0; n < patch_count(network); ++n)
    all.push_back(patch_nodes(network, n));
  return all;
}

Eigen::MatrixXd part(const Tangent& tangent, std::size_t patch) {
  const std::size_t cells = tangent.network->cells.size();
  return patch < cells ? cell_tangent(tangent, patch)
                       : matrix(patch_tangent(tangent, patch - cells));
}

Eigen::MatrixXd positive_part(const Tangent& tangent, std::size_t patch) {
  const std::size_t cells = tangent.network->cells.size();
  if (patch < cells) return statics::positive_part(cell_tangent(tangent, patch));
  NodalPatchTangent nodal_patch = patch_tangent(tangent, patch - cells);
  nodal_patch.shape = statics::positive_part(nodal_patch.shape);
  nodal_patch.volume = std::max(nodal_patch.volume, 0.);
  return matrix(nodal_patch);
}

std::vector<Vector3> product(const Tangent& tangent, std::span<const Vector3> vectors) {
  std::vector<Vector3> result(vectors.size(), Vector3::Zero());
  const auto all = patches(*tangent.network);
  for (std::size_t p = 0; p < all.size(); ++p) {
    Eigen::VectorXd stacked(row(all[p].size()));
    for (std::size_t a = 0; a < all[p].size(); ++a)
      stacked.segment<3>(row(a)) = vectors[all[p][a]];
    const Eigen::VectorXd answer = part(tangent, p) * stacked;
    for (std::size_t a = 0; a < all[p].size(); ++a)
      result[all[p][a]] += answer.segment<3>(row(a));
  }
  return result;
}

}  // namespace springcheck::mss
