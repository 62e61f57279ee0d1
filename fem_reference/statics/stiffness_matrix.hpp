#pragma once

#include <vector>

#include "fem_reference/cells/discretisation.hpp"
#include "fem_reference/statics/direct_solver.hpp"

namespace springcheck::fem_reference {

/// The global matrix of dofs 3 node + component, both triangles, its pattern laid out
/// once. Rows and columns of prescribed dofs hold a diagonal entry only.
class StiffnessMatrix {
 public:
  StiffnessMatrix(const Discretisation& body, const std::vector<bool>& prescribed);

  void clear();
  void add(const Cell& cell, const CellMatrix& contribution);

  /// To be called when all cells are in: gives prescribed dofs the largest diagonal entry
  /// of the free ones, which keeps the matrix well scaled.
  void finish();

  [[nodiscard]] const SparseMatrix& matrix() const { return matrix_; }
  [[nodiscard]] double largest_diagonal() const { return largest_diagonal_; }

 private:
  const std::vector<bool>& prescribed_;
  SparseMatrix matrix_;
  double largest_diagonal_ = 0;
};

}  // namespace springcheck::fem_reference
