#pragma once

#include <Eigen/SparseCore>
#include <memory>

namespace springcheck {

/// L L^T of symmetric matrices of one sparsity pattern, by CHOLMOD (supernodal, METIS's
/// ordering, found once). Of a matrix the lower triangle is read.
///
/// All functions throw std::bad_alloc where the memory is not enough, and
/// std::length_error where the factor is too large for CHOLMOD's integers. Neither says
/// anything about the matrix.
class SparseCholesky {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  SparseCholesky();
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// False when there is none: the matrix is not positive definite, and solve() must not
  /// be called.
  bool factor(const Matrix& matrix);

  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace springcheck
