#include "mss/forces/block_tangent.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace springcheck::mss {
BlockTangent::BlockTangent(const Network& network, std::vector<bool> is_free)
    : is_free_(std::move(is_free)), patches_(patches(network)) {
  const std::size_t nodes = is_free_.size() / 3;
  first_member_.assign(nodes + 1, 0);
  for (const auto& patch : patches_)
    for (const NodeIndex node : patch) ++first_member_[node + 1];
  for (std::size_t n = 0; n < nodes; ++n) first_member_[n + 1] += first_member_[n];
  members_.resize(first_member_.back());
  std::vector<std::size_t> next = first_member_;
  for (std::size_t p = 0; p < patches_.size(); ++p)
    for (std::size_t i = 0; i < patches_[p].size(); ++i)
      members_[next[patches_[p][i]]++] = {.patch = static_cast<std::uint32_t>(p),
                                          .place = static_cast<std::uint32_t>(i)};

  first_block_.push_back(0);
  std::vector<NodeIndex> row;
  for (NodeIndex n = 0; n < nodes; ++n) {
    lay_out_row(n, row);
    diagonal_.push_back(
        columns_.size() +
        static_cast<std::size_t>(std::ranges::lower_bound(row, n) - row.begin()));
    columns_.insert(columns_.end(), row.begin(), row.end());
    first_block_.push_back(columns_.size());
  }
  blocks_.resize(columns_.size());
}

void BlockTangent::lay_out_row(NodeIndex node, std::vector<NodeIndex>& columns) const {
  columns.assign(1, node);
  for (std::size_t m = first_member_[node]; m < first_member_[node + 1]; ++m) {
    const auto& patch = patches_[members_[m].patch];
    columns.insert(columns.end(), patch.begin(), patch.end());
  }
  std::ranges::sort(columns);
  const auto repeated = std::ranges::unique(columns);
  columns.erase(repeated.begin(), repeated.end());
}

void BlockTangent::assemble(const Tangent& tangent) {
  tbb::parallel_for(NodeIndex{0}, static_cast<NodeIndex>(nodes()),
                    [&](NodeIndex node) { assemble_row(node, tangent); });
}

void BlockTangent::assemble_row(NodeIndex node, const Tangent& tangent) {
  const auto first = columns_.begin() + static_cast<std::ptrdiff_t>(first_block_[node]);
  const auto end = columns_.begin() + static_cast<std::ptrdiff_t>(first_block_[node + 1]);
  const auto block_of = [&](NodeIndex column) -> Matrix3& {
    return blocks_[static_cast<std::size_t>(std::lower_bound(first, end, column) -
                                            columns_.begin())];
  };
  for (auto column = first; column < end; ++column) block_of(*column).setZero();
  for (std::size_t m = first_member_[node]; m < first_member_[node + 1]; ++m) {
    const auto [p, place] = members_[m];
    const auto& patch = patches_[p];
    const auto row = static_cast<Eigen::Index>(place);
    const auto width = static_cast<Eigen::Index>(patch.size());
    if (p < tangent.cells.size()) {
      for (Eigen::Index j = 0; j < width; ++j)
        block_of(patch[static_cast<std::size_t>(j)]) +=
            tangent.cells[p].block<3, 3>(3 * row, 3 * j);
      continue;
    }
    const StarTangent& star = tangent.stars[p - tangent.cells.size()];
    for (Eigen::Index j = 0; j < width; ++j)
      block_of(patch[static_cast<std::size_t>(j)]) += star_block(star, row, j);
  }
  for (auto column = first; column < end; ++column)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      if (!is_free_[3 * std::size_t{node} + i]) block_of(*column).row(at).setZero();
      if (!is_free_[3 * std::size_t{*column} + i]) block_of(*column).col(at).setZero();
    }
}

void BlockTangent::shift(double by) {
  for (std::size_t n = 0; n < nodes(); ++n)
    for (std::size_t i = 0; i < 3; ++i)
      if (is_free_[3 * n + i])
        blocks_[diagonal_[n]].diagonal()[static_cast<Eigen::Index>(i)] += by;
}

void BlockTangent::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& product) const {
  product.resize(x.size());
  tbb::parallel_for(std::size_t{0}, nodes(), [&](std::size_t n) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t b = first_block_[n]; b < first_block_[n + 1]; ++b)
      sum.noalias() += blocks_[b] * x.segment<3>(3 * Eigen::Index{columns_[b]});
    product.segment<3>(3 * static_cast<Eigen::Index>(n)) = sum;
  });
}

}  // namespace springcheck::mss
