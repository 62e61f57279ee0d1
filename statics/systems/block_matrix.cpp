#include "statics/systems/block_matrix.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace springcheck::statics {

BlockMatrix::BlockMatrix(Patches patches, std::size_t nodes)
    : patches_(std::move(patches)) {
  std::vector<std::vector<std::size_t>> patches_of(nodes);
  for (std::size_t p = 0; p < patches_.size(); ++p)
    for (const NodeIndex node : patches_[p]) patches_of[node].push_back(p);
  first_block_.push_back(0);
  std::vector<NodeIndex> row;
  for (NodeIndex n = 0; n < nodes; ++n) {
    row.assign(1, n);
    for (const std::size_t p : patches_of[n])
      row.insert(row.end(), patches_[p].begin(), patches_[p].end());
    std::ranges::sort(row);
    const auto repeated = std::ranges::unique(row);
    row.erase(repeated.begin(), repeated.end());
    diagonal_.push_back(
        columns_.size() +
        static_cast<std::size_t>(std::ranges::lower_bound(row, n) - row.begin()));
    columns_.insert(columns_.end(), row.begin(), row.end());
    first_block_.push_back(columns_.size());
  }
  blocks_.resize(columns_.size());
}

void BlockMatrix::assemble(
    const std::function<Eigen::MatrixXd(std::size_t patch)>& part) {
  // So many parts at once take 33 MB for nodal patches of 60 nodes. Rows are shared out
  // so that every thread has some of any few patches.
  constexpr std::size_t at_once = 128, row_groups = 16;
  for (Matrix3& block : blocks_) block.setZero();
  std::vector<Eigen::MatrixXd> parts(std::min(at_once, patches_.size()));
  for (std::size_t first = 0; first < patches_.size(); first += at_once) {
    const std::size_t count = std::min(at_once, patches_.size() - first);
    tbb::parallel_for(std::size_t{0}, count,
                      [&](std::size_t i) { parts[i] = part(first + i); });
    tbb::parallel_for(std::size_t{0}, row_groups, [&](std::size_t group) {
      for (std::size_t i = 0; i < count; ++i) {
        const std::vector<NodeIndex>& nodes = patches_[first + i];
        for (std::size_t a = 0; a < nodes.size(); ++a) {
          if (nodes[a] % row_groups != group) continue;
          for (std::size_t b = 0; b < nodes.size(); ++b)
            blocks_[place(nodes[a], nodes[b])] += parts[i].block<3, 3>(
                static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b));
        }
      }
    });
  }
}

void BlockMatrix::scale(double by) {
  for (Matrix3& block : blocks_) block *= by;
}

Matrix3& BlockMatrix::block(NodeIndex row, NodeIndex column) {
  return blocks_[place(row, column)];
}

std::size_t BlockMatrix::place(NodeIndex row, NodeIndex column) const {
  const auto first = columns_.begin() + static_cast<std::ptrdiff_t>(first_block_[row]);
  const auto end = columns_.begin() + static_cast<std::ptrdiff_t>(first_block_[row + 1]);
  return static_cast<std::size_t>(std::lower_bound(first, end, column) -
                                  columns_.begin());
}

void BlockMatrix::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& product) const {
  product.resize(x.size());
  tbb::parallel_for(std::size_t{0}, nodes(), [&](std::size_t n) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t b = first_block_[n]; b < first_block_[n + 1]; ++b)
      sum.noalias() += blocks_[b] * x.segment<3>(3 * Eigen::Index{columns_[b]});
    product.segment<3>(3 * static_cast<Eigen::Index>(n)) = sum;
  });
}

std::vector<Vector3> product(const BlockMatrix& matrix,
                             std::span<const Vector3> vectors) {
  std::vector<Vector3> result(vectors.size());
  Eigen::VectorXd of_all;
  matrix.multiply(
      Eigen::Map<const Eigen::VectorXd>(vectors.data()->data(), 3 * std::ssize(vectors)),
      of_all);
  Eigen::Map<Eigen::VectorXd>(result.data()->data(), of_all.size()) = of_all;
  return result;
}

}  // namespace springcheck::statics
