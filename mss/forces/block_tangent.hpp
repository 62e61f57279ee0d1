#pragma once

#include <Eigen/Core>
#include <vector>

#include "mss/forces/tangent.hpp"

namespace springcheck::mss {

/// A tangent's patches put together in 3x3 blocks [N/m], row by row over all nodes, both
/// triangles. Rows and columns of prescribed components are zero. Vectors hold all
/// components, 3 node + component. In parallel, to the same bits on any number of
/// threads: every row is summed by one of them, in the order of the patches.
class BlockTangent {
 public:
  /// is_free: one entry per component.
  BlockTangent(const Network& network, std::vector<bool> is_free);

  void assemble(const Tangent& tangent);

  /// Adds a multiple of the identity of the free components.
  void shift(double by);

  [[nodiscard]] const Matrix3& diagonal(NodeIndex node) const {
    return blocks_[diagonal_[node]];
  }
  [[nodiscard]] std::size_t nodes() const { return diagonal_.size(); }
  [[nodiscard]] const std::vector<bool>& is_free() const { return is_free_; }

  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& product) const;

 private:
  struct Member {
    std::uint32_t patch;
    std::uint32_t place;  // of the node among the patch's
  };
  void lay_out_row(NodeIndex node, std::vector<NodeIndex>& columns) const;
  void assemble_row(NodeIndex node, const Tangent& tangent);

  std::vector<bool> is_free_;
  std::vector<std::vector<NodeIndex>> patches_;
  std::vector<std::size_t> first_member_;  // of each node, and the end
  std::vector<Member> members_;            // the patches that a node belongs to
  std::vector<std::size_t> first_block_;   // of each node's row, and the end
  std::vector<NodeIndex> columns_;         // of the blocks, ascending in each row
  std::vector<std::size_t> diagonal_;      // blocks on the diagonal
  std::vector<Matrix3> blocks_;
};

}  // namespace springcheck::mss
