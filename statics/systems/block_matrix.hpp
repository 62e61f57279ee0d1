#pragma once

#include <functional>
#include <span>
#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck::statics {

/// Nodes of each of the patches that a body's tangent is a sum over.
using Patches = std::vector<std::vector<NodeIndex>>;

/// A symmetric matrix in 3x3 blocks [N/m], one for every two nodes that share a patch,
/// row by row, both triangles; of all components, prescribed ones too. Vectors hold all
/// components, 3 node + component. It is summed in parallel, to the same bits on any
/// number of threads: every row is summed by one of them, in the order of the patches.
class BlockMatrix {
 public:
  BlockMatrix(Patches patches, std::size_t nodes);

  [[nodiscard]] std::size_t nodes() const { return diagonal_.size(); }

  /// Sums up the patches' parts, matrices in 3x3 blocks in the order of the patch's
  /// nodes. `part` is called in parallel, and what it returns kept no longer than it
  /// takes to add it: a million hexahedra of 27 nodes have 50 GB of them.
  void assemble(const std::function<Eigen::MatrixXd(std::size_t patch)>& part);

  void scale(double by);

  /// The block between two nodes that share a patch.
  [[nodiscard]] Matrix3& block(NodeIndex row, NodeIndex column);

  [[nodiscard]] const Matrix3& diagonal(NodeIndex node) const {
    return blocks_[diagonal_[node]];
  }

  /// Calls visit(column, block) for the blocks of a node's row, by ascending column.
  template <class Visit>
  void for_each_in_row(NodeIndex row, Visit&& visit) const {
    for (std::size_t b = first_block_[row]; b < first_block_[row + 1]; ++b)
      visit(columns_[b], blocks_[b]);
  }

  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& product) const;

 private:
  [[nodiscard]] std::size_t place(NodeIndex row, NodeIndex column) const;

  Patches patches_;
  std::vector<std::size_t> first_block_;  // of each node's row, and the end
  std::vector<NodeIndex> columns_;        // of the blocks, ascending in each row
  std::vector<std::size_t> diagonal_;     // blocks on the diagonal
  std::vector<Matrix3> blocks_;
};

/// The matrix times one vector per node.
std::vector<Vector3> product(const BlockMatrix& matrix, std::span<const Vector3> vectors);

}  // namespace springcheck::statics
