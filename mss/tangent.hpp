#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <span>
#include <vector>

#include "mss/network.hpp"

namespace springcheck::mss {

using CellMatrix = Eigen::Matrix<double, 24, 24>;

/// Second derivative of one cell's energy [N/m], 3x3 blocks in corner order: per spring
/// k [(1 - L/|d|)(I - n n^T) + n n^T] between its two corners, and from the volume
/// kappa/V0 [dV dV^T + (V - V0) d2V].
CellMatrix cell_tangent(const Cell& cell, double volume_modulus,
                        std::span<const Vector3> rest_positions,
                        std::span<const Vector3> positions);

/// cell_tangent of every cell, in parallel.
std::vector<CellMatrix> cell_tangents(const Network& network,
                                      std::span<const Vector3> positions);

/// Sets the negative eigenvalues of every matrix to zero, in parallel. Assembled, such
/// matrices give a descent direction even where the true tangent is indefinite.
void clamp_to_positive(std::vector<CellMatrix>& matrices);

/// Puts cell matrices together over the free components: lower triangle of a sparse
/// matrix whose pattern is laid out once.
class FreeAssembly {
 public:
  /// is_free: one entry per component, 3 node + component.
  FreeAssembly(const Network& network, const std::vector<bool>& is_free);

  [[nodiscard]] Eigen::Index size() const { return matrix_.rows(); }

  /// The unknown of a free component, -1 for a prescribed one. Ascending with them.
  [[nodiscard]] Eigen::Index unknown(NodeIndex node, int component) const {
    return unknowns_[3 * std::size_t{node} + static_cast<std::size_t>(component)];
  }

  [[nodiscard]] const Eigen::SparseMatrix<double>& assemble(
      const std::vector<CellMatrix>& matrices);

 private:
  std::vector<Eigen::Index> unknowns_;
  Eigen::SparseMatrix<double> matrix_;
  std::vector<std::int32_t> places_;  // of each cell's 24 x 24 entries in the values
};

}  // namespace springcheck::mss
