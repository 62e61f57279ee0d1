#include "fem_reference/statics/stiffness_matrix.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace springcheck::fem_reference {
namespace {

/// Nodes that share a cell with each node, ascending.
std::vector<std::vector<NodeIndex>> neighbours(const Discretisation& body) {
  std::vector<std::vector<NodeIndex>> near(body.nodes.size());
  for (const Cell& cell : body.cells)
    for (const NodeIndex node : cell.nodes)
      near[node].insert(near[node].end(), cell.nodes.begin(), cell.nodes.end());
  for (auto& nodes : near) {
    std::ranges::sort(nodes);
    const auto repeated = std::ranges::unique(nodes);
    nodes.erase(repeated.begin(), repeated.end());
    nodes.shrink_to_fit();
  }
  return near;
}

}  // namespace

StiffnessMatrix::StiffnessMatrix(const Discretisation& body,
                                 const std::vector<bool>& prescribed)
    : prescribed_(prescribed) {
  const auto near = neighbours(body);
  const auto dofs = static_cast<int>(prescribed.size());
  const auto for_column = [&](int dof, const auto& visit) {
    if (prescribed_[static_cast<std::size_t>(dof)]) return visit(dof);
    for (const NodeIndex node : near[static_cast<std::size_t>(dof) / 3])
      for (unsigned int i = 0; i < 3; ++i)
        if (!prescribed_[3 * node + i]) visit(static_cast<int>(3 * node + i));
  };
  std::int64_t entries = 0;
  for (int dof = 0; dof < dofs; ++dof) for_column(dof, [&](int) { ++entries; });
  if (entries > std::numeric_limits<int>::max())
    throw std::length_error("a stiffness matrix with more than 2^31 entries");
  matrix_.resize(dofs, dofs);
  int* const start = matrix_.outerIndexPtr();
  start[0] = 0;
  for (int dof = 0; dof < dofs; ++dof) {
    start[dof + 1] = start[dof];
    for_column(dof, [&](int) { ++start[dof + 1]; });
  }
  matrix_.resizeNonZeros(start[dofs]);
  int* row = matrix_.innerIndexPtr();
  for (int dof = 0; dof < dofs; ++dof)
    for_column(dof, [&](int other) { *row++ = other; });
}

void StiffnessMatrix::clear() {
  std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
}

void StiffnessMatrix::add(const Cell& cell, const CellMatrix& contribution) {
  const int* const start = matrix_.outerIndexPtr();
  const int* const rows = matrix_.innerIndexPtr();
  double* const values = matrix_.valuePtr();
  for (Eigen::Index j = 0; j < contribution.cols(); ++j) {
    const std::size_t column =
        3 * cell.nodes[static_cast<std::size_t>(j) / 3] + static_cast<std::size_t>(j) % 3;
    if (prescribed_[column]) continue;
    const int *const first = rows + start[column], *const last = rows + start[column + 1];
    for (std::size_t a = 0; a < cell.nodes.size(); ++a) {
      const std::size_t dof = 3 * cell.nodes[a];
      auto place = std::lower_bound(first, last, static_cast<int>(dof)) - rows;
      for (std::size_t i = 0; i < 3; ++i)
        if (!prescribed_[dof + i])
          values[place++] += contribution(static_cast<Eigen::Index>(3 * a + i), j);
    }
  }
}

void StiffnessMatrix::finish() {
  largest_diagonal_ = 0;
  for (Eigen::Index dof = 0; dof < matrix_.rows(); ++dof)
    if (!prescribed_[static_cast<std::size_t>(dof)])
      largest_diagonal_ = std::max(largest_diagonal_, matrix_.coeff(dof, dof));
  const double diagonal = largest_diagonal_ > 0 ? largest_diagonal_ : 1;
  for (Eigen::Index dof = 0; dof < matrix_.rows(); ++dof)
    if (prescribed_[static_cast<std::size_t>(dof)])
      matrix_.valuePtr()[matrix_.outerIndexPtr()[dof]] = diagonal;
}

}  // namespace springcheck::fem_reference
