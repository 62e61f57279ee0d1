#include "mss/forces/assembly.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace springcheck::mss {
namespace {

/// Of each node those of higher number with which it shares a patch, ascending.
std::vector<std::vector<NodeIndex>> higher_neighbours(
    const std::vector<std::vector<NodeIndex>>& patches, std::size_t nodes) {
  std::vector<std::vector<NodeIndex>> neighbours(nodes);
  for (const auto& patch : patches)
    for (const NodeIndex a : patch)
      for (const NodeIndex b : patch)
        if (b > a) neighbours[a].push_back(b);
  for (auto& list : neighbours) {
    std::ranges::sort(list);
    const auto repeated = std::ranges::unique(list);
    list.erase(repeated.begin(), repeated.end());
  }
  return neighbours;
}

}  // namespace

int FreeAssembly::free_count(NodeIndex node) const {
  int count = 0;
  for (int i = 0; i < 3; ++i) count += unknown(node, i) >= 0 ? 1 : 0;
  return count;
}

FreeAssembly::FreeAssembly(const Network& network, const std::vector<bool>& is_free)
    : patches_(patches(network)), unknowns_(is_free.size(), -1) {
  Eigen::Index count = 0;
  for (std::size_t i = 0; i < is_free.size(); ++i)
    if (is_free[i]) unknowns_[i] = count++;

  const std::size_t nodes = is_free.size() / 3;
  const auto higher = higher_neighbours(patches_, nodes);
  neighbours_.resize(nodes);
  std::vector<std::int32_t> starts{0};
  std::vector<std::int32_t> rows;
  for (NodeIndex a = 0; a < nodes; ++a) {
    std::int32_t before = 0;
    for (const NodeIndex b : higher[a]) {
      neighbours_[a].push_back({.node = b, .rows_before = before});
      before += free_count(b);
    }
    for (int column = 0; column < 3; ++column) {
      if (unknown(a, column) < 0) continue;
      const auto append = [&](NodeIndex b, int from) {
        for (int i = from; i < 3; ++i)
          if (const Eigen::Index at = unknown(b, i); at >= 0)
            rows.push_back(static_cast<std::int32_t>(at));
      };
      append(a, column);
      for (const NodeIndex b : higher[a]) append(b, 0);
      if (rows.size() > std::numeric_limits<std::int32_t>::max())
        throw std::length_error("tangent with more than 2^31 entries");
      starts.push_back(static_cast<std::int32_t>(rows.size()));
    }
  }
  const std::vector<double> zeros(rows.size(), 0.0);
  matrix_ = Eigen::Map<const Eigen::SparseMatrix<double>>(
      count, count, static_cast<Eigen::Index>(rows.size()), starts.data(), rows.data(),
      zeros.data());
}

const Eigen::SparseMatrix<double>& FreeAssembly::assemble(const Tangent& tangent) {
  std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
  const std::size_t cells = tangent.cells.size();
  for (std::size_t c = 0; c < cells; ++c) add(patches_[c], tangent.cells[c]);
  for (std::size_t n = 0; n < tangent.stars.size(); ++n)
    add(patches_[cells + n], matrix(tangent.stars[n]));
  return matrix_;
}

void FreeAssembly::add(std::span<const NodeIndex> nodes, const Eigen::MatrixXd& patch) {
  for (std::size_t j = 0; j < nodes.size(); ++j)
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const NodeIndex column_node = nodes[j], row_node = nodes[i];
      if (row_node < column_node) continue;
      // A column holds its own node's rows from the diagonal on, then its neighbours'.
      std::int32_t before = 0;
      if (row_node > column_node)
        before = std::ranges::lower_bound(neighbours_[column_node], row_node, {},
                                          &Neighbour::node)
                     ->rows_before;
      int own_rows = free_count(column_node);
      for (int s = 0; s < 3; ++s) {
        const Eigen::Index column = unknown(column_node, s);
        if (column < 0) continue;
        double* value = matrix_.valuePtr() + matrix_.outerIndexPtr()[column];
        if (row_node > column_node) value += own_rows + before;
        --own_rows;
        for (int r = row_node > column_node ? 0 : s; r < 3; ++r)
          if (unknown(row_node, r) >= 0)
            *value++ += patch(static_cast<Eigen::Index>(3 * i) + r,
                              static_cast<Eigen::Index>(3 * j) + s);
      }
    }
}

}  // namespace springcheck::mss
