#pragma once

#include <Eigen/SparseCore>

#include "mss/forces/tangent.hpp"

namespace springcheck::mss {

/// Puts a tangent's patches together over the free components: lower triangle of a sparse
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

  [[nodiscard]] const Eigen::SparseMatrix<double>& assemble(const Tangent& tangent);

 private:
  void add(std::span<const NodeIndex> nodes, const Eigen::MatrixXd& patch);
  [[nodiscard]] int free_count(NodeIndex node) const;

  struct Neighbour {
    NodeIndex node;
    std::int32_t rows_before;  // of the neighbours of smaller number
  };

  std::vector<std::vector<NodeIndex>> patches_;
  std::vector<Eigen::Index> unknowns_;
  // Of each node those of higher number with which it shares a patch, ascending:
  std::vector<std::vector<Neighbour>> neighbours_;
  Eigen::SparseMatrix<double> matrix_;
};

}  // namespace springcheck::mss
