#include "statics/systems/multigrid.hpp"

#include <algorithm>
#include <optional>

#include "statics/systems/aggregation.hpp"
#include "statics/systems/chebyshev.hpp"
#include "statics/systems/direct_solver.hpp"
#include "statics/systems/sparse_cholesky.hpp"

namespace springcheck::statics {
namespace {

/// The three translations and three rotations of the nodes, 0 at prescribed components,
/// as columns.
Eigen::MatrixXd rigid_motions(std::span<const Vector3> nodes, const Unknowns& unknowns) {
  Vector3 centre = Vector3::Zero();
  for (const Vector3& x : nodes) centre += x / static_cast<double>(nodes.size());
  double size = 0;
  for (const Vector3& x : nodes) size = std::max(size, (x - centre).norm());
  Eigen::MatrixXd motions =
      Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(nodes.size()), 6);
  for (NodeIndex n = 0; n < nodes.size(); ++n) {
    const Vector3 arm = (nodes[n] - centre) / size;
    for (int i = 0; i < 3; ++i) {
      if (unknowns.of(n, i) < 0) continue;
      const auto row = 3 * Eigen::Index{n} + i;
      motions(row, i) = 1;
      for (int axis = 0; axis < 3; ++axis)
        motions(row, 3 + axis) = Vector3::Unit(axis).cross(arm)[i];
    }
  }
  return motions;
}

/// The blocks as they are, rows and columns of prescribed components with the largest
/// entry of the diagonal alone: the matrix stays well scaled.
RowMatrix without_prescribed(const BlockMatrix& matrix, const Unknowns& unknowns) {
  const auto size = 3 * static_cast<Eigen::Index>(matrix.nodes());
  double largest = 0;
  Eigen::VectorXi entries = Eigen::VectorXi::Ones(size);
  const auto for_each_entry = [&](const auto& visit) {
    for (NodeIndex n = 0; n < matrix.nodes(); ++n)
      for (int i = 0; i < 3; ++i) {
        if (unknowns.of(n, i) < 0) continue;
        matrix.for_each_in_row(n, [&](NodeIndex other, const Matrix3& block) {
          for (int k = 0; k < 3; ++k)
            if (unknowns.of(other, k) >= 0)
              visit(3 * Eigen::Index{n} + i, 3 * Eigen::Index{other} + k, block(i, k));
        });
      }
  };
  for_each_entry([&](Eigen::Index row, Eigen::Index column, double value) {
    if (row == column)
      largest = std::max(largest, value);
    else
      ++entries[row];
  });
  RowMatrix copy(size, size);
  copy.reserve(entries);
  for_each_entry([&](Eigen::Index row, Eigen::Index column, double value) {
    copy.insert(row, column) = value;
  });
  for (NodeIndex n = 0; n < matrix.nodes(); ++n)
    for (int i = 0; i < 3; ++i)
      if (unknowns.of(n, i) < 0) {
        const auto row = 3 * Eigen::Index{n} + i;
        copy.insert(row, row) = largest;
      }
  copy.makeCompressed();
  return copy;
}

}  // namespace

struct Multigrid::Hierarchy {
  struct Level {
    RowMatrix matrix;
    Chebyshev smoother;
    RowMatrix prolongation, restriction;  // from the next coarser level, and to it
  };
  std::vector<Level> levels;  // but the coarsest
  SparseCholesky coarsest;

  [[nodiscard]] Eigen::VectorXd cycle(std::size_t depth,
                                      const Eigen::VectorXd& right) const {
    if (depth == levels.size()) return coarsest.solve(right);
    const Level& level = levels[depth];
    Eigen::VectorXd x = level.smoother.from_zero(level.matrix, right);
    const Eigen::VectorXd left = right - product(level.matrix, x);
    x += product(level.prolongation, cycle(depth + 1, product(level.restriction, left)));
    x += level.smoother.from_zero(level.matrix, right - product(level.matrix, x));
    return x;
  }
};

Multigrid::Multigrid(std::span<const Vector3> nodes, const Unknowns& unknowns)
    : unknowns_(unknowns), rigid_motions_(rigid_motions(nodes, unknowns)) {}

Multigrid::~Multigrid() = default;

void Multigrid::prepare(const BlockMatrix& matrix) {
  auto hierarchy = std::make_unique<Hierarchy>();
  Aggregation of = aggregation(without_prescribed(matrix, unknowns_), rigid_motions_);
  for (std::size_t level = 0; level < of.prolongations.size(); ++level) {
    RowMatrix restriction = of.prolongations[level].transpose();
    Chebyshev smoother(of.matrices[level]);
    hierarchy->levels.push_back({.matrix = std::move(of.matrices[level]),
                                 .smoother = std::move(smoother),
                                 .prolongation = std::move(of.prolongations[level]),
                                 .restriction = std::move(restriction)});
  }
  factor_shifted(hierarchy->coarsest, of.matrices.back());
  hierarchy_ = std::move(hierarchy);
}

Eigen::VectorXd Multigrid::times(const Eigen::VectorXd& residual) const {
  return hierarchy_->cycle(0, residual);
}

}  // namespace springcheck::statics
