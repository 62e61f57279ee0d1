#pragma once

#include <Eigen/SparseCore>
#include <memory>

namespace springcheck::fem_reference {

/// Symmetric; both triangles are stored.
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Direct solver for symmetric matrices of one sparsity pattern.
class DirectSolver {
 public:
  DirectSolver();
  ~DirectSolver();
  DirectSolver(const DirectSolver&) = delete;
  DirectSolver& operator=(const DirectSolver&) = delete;

  /// LL^T by CHOLMOD (supernodal). False when there is none: the matrix is not positive
  /// definite, and solve() must not be called.
  bool factor_definite(const SparseMatrix& matrix);

  /// LDL^T without pivoting, slower, for matrices that need not be definite. False when a
  /// pivot is zero.
  bool factor_indefinite(const SparseMatrix& matrix);

  /// Negative pivots of the last factor_indefinite(): as many as negative eigenvalues.
  [[nodiscard]] int negative_pivots() const;

  /// Of both kinds so far.
  [[nodiscard]] int factorisations() const;

  /// Solves with the last factor made.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Solvers;
  std::unique_ptr<Solvers> solvers_;
};

}  // namespace springcheck::fem_reference
