#pragma once

#include <optional>
#include <random>
#include <span>
#include <variant>

#include "statics/systems/direct_solver.hpp"
#include "statics/systems/iterative_solver.hpp"
#include "statics/systems/linear_solver.hpp"

namespace springcheck::statics {

/// The matrix of a body's linear systems and its solver. Vectors hold the unknowns.
class System {
 public:
  /// nodes at rest [m]; is_free: one entry per component; solver: any but automatic.
  System(std::span<const Vector3> nodes, Patches patches,
         const std::vector<bool>& is_free, LinearSolver solver,
         int iteration_limit = 20'000);

  [[nodiscard]] const Unknowns& unknowns() const { return unknowns_; }
  [[nodiscard]] BlockMatrix& matrix() { return matrix_; }
  [[nodiscard]] const BlockMatrix& matrix() const { return matrix_; }

  /// Prepares the solver; it must be called when the matrix has changed.
  void prepare();

  /// Does the like for a matrix that cannot be negative, and may be singular.
  void prepare_semidefinite();

  /// Whether the matrix is positive definite. None where the iterative solver gave up
  /// before it could tell.
  [[nodiscard]] std::optional<bool> is_definite(std::mt19937_64& random);

  /// Solves, iteratively to the accuracy relative to the right-hand side, or as far as
  /// the limit of iterations lets it come, which counts as truncated. Returns none where
  /// the matrix was found not to be positive definite.
  [[nodiscard]] std::optional<Eigen::VectorXd> solve(const Eigen::VectorXd& right,
                                                     double accuracy);

  /// Unit vector of negative curvature of a matrix that is not positive definite.
  [[nodiscard]] Eigen::VectorXd negative_curvature(std::mt19937_64& random);

  /// Iterations so far; none if the solver is direct.
  [[nodiscard]] std::optional<int> iterations() const;
  /// Factorisations so far; none if it is iterative.
  [[nodiscard]] std::optional<int> factorisations() const;
  /// Solutions so far that the limit of iterations has cut short.
  [[nodiscard]] int truncated() const { return truncated_; }

 private:
  Unknowns unknowns_;
  BlockMatrix matrix_;
  std::variant<DirectSolver, IterativeSolver> solver_;
  int truncated_ = 0;
};

/// Prepares a direct solver for a matrix that need not be positive definite, shifted
/// until it is; returns whether it was.
bool prepare_shifted(System& system);

}  // namespace springcheck::statics
