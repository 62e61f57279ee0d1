#pragma once

#include <optional>
#include <random>

#include "statics/systems/free_triangle.hpp"
#include "statics/systems/sparse_cholesky.hpp"

namespace springcheck::statics {

/// Factors a matrix plus the smallest of a series of multiples of the identity that makes
/// it positive definite. Returns how many factors were tried.
int factor_shifted(SparseCholesky& cholesky, Eigen::SparseMatrix<double> matrix);

/// Solves with a matrix by its Cholesky factor, which exists where it is positive
/// definite. The ordering is found once. Refers to the matrix and the unknowns, in which
/// vectors are.
class DirectSolver {
 public:
  DirectSolver(const BlockMatrix& matrix, const Unknowns& unknowns);

  /// Factors the matrix; it must be called when that has changed.
  void prepare();

  /// Does the like for a matrix that cannot be negative, shifted where it is singular.
  void prepare_semidefinite();

  [[nodiscard]] bool is_definite() const { return definite_; }

  [[nodiscard]] int factorisations() const { return factorisations_; }  // so far

  /// The solution, or none where what was prepared is not positive definite.
  [[nodiscard]] std::optional<Eigen::VectorXd> solve(const Eigen::VectorXd& right);

  /// Unit vector of the most negative curvature of a matrix that is not positive
  /// definite, by inverse iteration on the matrix shifted just far enough.
  [[nodiscard]] Eigen::VectorXd negative_curvature(std::mt19937_64& random);

 private:
  const BlockMatrix& matrix_;
  const Unknowns& unknowns_;
  FreeTriangle triangle_;
  SparseCholesky cholesky_;
  bool definite_ = false;
  int factorisations_ = 0;
};

}  // namespace springcheck::statics
