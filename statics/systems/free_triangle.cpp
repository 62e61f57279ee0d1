#include "statics/systems/free_triangle.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace springcheck::statics {
namespace {

/// Calls begin_column(unknown) for each and entry(row, value) for each entry of it from
/// the diagonal on: by symmetry a node's row of blocks is its column.
template <class BeginColumn, class Entry>
void for_each_entry(const BlockMatrix& matrix, const Unknowns& unknowns,
                    BeginColumn&& begin_column, Entry&& entry) {
  for (NodeIndex node = 0; node < matrix.nodes(); ++node)
    for (int i = 0; i < 3; ++i) {
      const Eigen::Index column = unknowns.of(node, i);
      if (column < 0) continue;
      begin_column(column);
      matrix.for_each_in_row(node, [&](NodeIndex other, const Matrix3& block) {
        if (other < node) return;
        for (int k = 0; k < 3; ++k)
          if (const Eigen::Index row = unknowns.of(other, k); row >= column)
            entry(row, block(i, k));
      });
    }
}

}  // namespace

Eigen::VectorXd diagonal(const BlockMatrix& matrix, const Unknowns& unknowns) {
  Eigen::VectorXd entries(unknowns.count());
  for (Eigen::Index u = 0; u < unknowns.count(); ++u) {
    const Eigen::Index component = unknowns.components()[static_cast<std::size_t>(u)];
    const auto i = component % 3;
    entries[u] = matrix.diagonal(static_cast<NodeIndex>(component / 3))(i, i);
  }
  return entries;
}

FreeTriangle::FreeTriangle(const BlockMatrix& matrix, const Unknowns& unknowns)
    : unknowns_(unknowns), copy_(unknowns.count(), unknowns.count()) {
  std::int64_t entries = 0;
  for_each_entry(
      matrix, unknowns_, [](Eigen::Index) {}, [&](Eigen::Index, double) { ++entries; });
  if (entries > std::numeric_limits<int>::max())
    throw std::length_error("a tangent with more than 2^31 entries");
  copy_.resizeNonZeros(entries);
  int* row_of = copy_.innerIndexPtr();
  for_each_entry(
      matrix, unknowns_,
      [&](Eigen::Index column) {
        copy_.outerIndexPtr()[column] = static_cast<int>(row_of - copy_.innerIndexPtr());
      },
      [&](Eigen::Index row, double) { *row_of++ = static_cast<int>(row); });
  copy_.outerIndexPtr()[unknowns.count()] = static_cast<int>(entries);
}

const Eigen::SparseMatrix<double>& FreeTriangle::copy_of(const BlockMatrix& matrix) {
  double* value_of = copy_.valuePtr();
  for_each_entry(
      matrix, unknowns_, [](Eigen::Index) {},
      [&](Eigen::Index, double value) { *value_of++ = value; });
  return copy_;
}

}  // namespace springcheck::statics
