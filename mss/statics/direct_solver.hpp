#pragma once

#include <optional>
#include <random>

#include "meshing/sparse_cholesky.hpp"
#include "mss/forces/assembly.hpp"

namespace springcheck::mss {

/// Solves with a tangent by its Cholesky factor, which exists where the tangent is
/// positive definite. The ordering is found once. Vectors hold the free components.
class DirectSolver {
 public:
  DirectSolver(const Network& network, const std::vector<bool>& is_free);

  void prepare(const Tangent& tangent);

  /// For a tangent of clamped patches: shifted where it is singular.
  void prepare_clamped(const Tangent& tangent);

  [[nodiscard]] bool is_definite() const { return definite_; }

  [[nodiscard]] int factorisations() const { return factorisations_; }  // so far

  /// None where what was prepared is not positive definite.
  [[nodiscard]] std::optional<Eigen::VectorXd> solve(const Eigen::VectorXd& right);

  /// Unit vector of the most negative curvature of a tangent that is not positive
  /// definite, by inverse iteration on the tangent shifted just far enough.
  [[nodiscard]] Eigen::VectorXd negative_curvature(const Tangent& tangent,
                                                   std::mt19937_64& random);

 private:
  void factor(const Eigen::SparseMatrix<double>& matrix);
  void factor_shifted(Eigen::SparseMatrix<double> matrix);

  FreeAssembly assembly_;
  SparseCholesky cholesky_;
  bool definite_ = false;
  int factorisations_ = 0;
};

}  // namespace springcheck::mss
