#pragma once

#include <memory>
#include <optional>
#include <random>

#include "statics/systems/preconditioner.hpp"
#include "statics/systems/unknowns.hpp"

namespace springcheck::statics {

/// Solves with a matrix by preconditioned conjugate gradients. Accuracies are of the
/// residual in the preconditioner's norm. A preconditioner that lasts is prepared anew
/// when is_definite has come to need half as many iterations again as when it was new.
/// Refers to the matrix and the unknowns, in which vectors are.
class IterativeSolver {
 public:
  /// iteration_limit: of one solution.
  IterativeSolver(const BlockMatrix& matrix, const Unknowns& unknowns,
                  std::unique_ptr<Preconditioner> preconditioner, int iteration_limit);

  /// Prepares for the matrix; it must be called when that has changed.
  void prepare();

  /// Does the like for a matrix that cannot be negative, and may be singular: it is
  /// shifted by 1e-8 of its largest entry.
  void prepare_semidefinite();

  /// Whether the matrix is positive definite, from a random right-hand side. Conjugate
  /// gradients that meet positive curvature alone multiply the residual by a polynomial
  /// of positive roots that is 1 at 0: at a negative eigenvalue it is above 1, so that
  /// part of the residual never gets smaller than it was, and the whole does not fall to
  /// 1e-6 of its beginning. Of a random vector of n components a part is that small with
  /// a probability of 1e-6 sqrt(n). None where the limit of iterations ends it before.
  [[nodiscard]] std::optional<bool> is_definite(std::mt19937_64& random);

  struct Answer {
    Eigen::VectorXd solution;
    // False at the limit of iterations: the last iterate, which is less accurate and
    // still lowers the energy's quadratic model.
    bool converged;
  };
  /// The answer, or none on meeting a direction of negative curvature.
  [[nodiscard]] std::optional<Answer> solve(const Eigen::VectorXd& right,
                                            double accuracy);

  /// Unit vector of negative curvature of a matrix that is_definite found not to be
  /// positive definite: the direction on which it ended.
  [[nodiscard]] Eigen::VectorXd negative_curvature(std::mt19937_64& random);

  [[nodiscard]] int iterations() const { return iterations_; }  // all together

 private:
  struct Ending {
    Eigen::VectorXd solution;     // of all components
    Eigen::VectorXd direction{};  // the last one
    bool converged;
    bool definite;  // curvature positive along every direction
    int iterations = 0;
  };
  [[nodiscard]] Ending conjugate_gradients(const Eigen::VectorXd& right, double accuracy);
  void product_on_free(const Eigen::VectorXd& x, Eigen::VectorXd& product) const;
  void renew_preconditioner();

  const BlockMatrix& matrix_;
  const Unknowns& unknowns_;
  std::unique_ptr<Preconditioner> preconditioner_;
  int iteration_limit_;
  double shift_ = 0;           // of the diagonal, as the matrix was prepared [N/m]
  Eigen::VectorXd curvature_;  // the direction on which is_definite ended
  bool has_preconditioner_ = false;
  bool preconditioner_fails_ = false;       // prepared for a matrix that is not definite
  std::optional<int> iterations_when_new_;  // of is_definite, with the preconditioner
  int iterations_ = 0;
};

}  // namespace springcheck::statics
