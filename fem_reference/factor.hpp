#pragma once

#include <Eigen/SparseCore>
#include <memory>

namespace springcheck::fem_reference {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Direct solver for symmetric matrices of one sparsity pattern, given by their lower
/// triangle.
class SymmetricFactor {
 public:
  SymmetricFactor();
  ~SymmetricFactor();
  SymmetricFactor(const SymmetricFactor&) = delete;
  SymmetricFactor& operator=(const SymmetricFactor&) = delete;

  /// LL^T by CHOLMOD (supernodal). False when there is none: the matrix is not positive
  /// definite, and solve() must not be called.
  bool factor_definite(const SparseMatrix& lower);

  /// LDL^T without pivoting, slower, for matrices that need not be definite. False when a
  /// pivot is zero.
  bool factor_indefinite(const SparseMatrix& lower);

  /// Negative pivots of the last factor_indefinite(): as many as negative eigenvalues.
  [[nodiscard]] int negative_pivots() const;

  /// Solves with the last factor made.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Solvers;
  std::unique_ptr<Solvers> solvers_;
};

}  // namespace springcheck::fem_reference
