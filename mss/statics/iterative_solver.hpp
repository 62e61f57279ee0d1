#pragma once

#include <optional>
#include <random>

#include "mss/forces/block_tangent.hpp"

namespace springcheck::mss {

/// Solves with a tangent by conjugate gradients, preconditioned by the nodes' 3x3 blocks,
/// of which negative eigenvalues count by their size. Vectors hold the free components;
/// accuracies are of the residual in the preconditioner's norm.
class IterativeSolver {
 public:
  /// iteration_limit: of one solution.
  IterativeSolver(const Network& network, const std::vector<bool>& is_free,
                  int iteration_limit = 20'000);

  void prepare(const Tangent& tangent);

  /// For a tangent of clamped patches, which may be singular: shifted by 1e-8 of its
  /// largest entry.
  void prepare_clamped(const Tangent& tangent);

  /// Whether the tangent is positive definite, from a random right-hand side. Conjugate
  /// gradients that meet positive curvature alone multiply the residual by a polynomial
  /// of positive roots that is 1 at 0: at a negative eigenvalue it is above 1, so that
  /// part of the residual never gets smaller than it was, and the whole does not fall to
  /// 1e-6 of its beginning. Of a random vector of n components a part is that small with
  /// a probability of 1e-6 sqrt(n). None where the limit of iterations ends it before.
  [[nodiscard]] std::optional<bool> is_definite(std::mt19937_64& random);

  /// None on meeting a direction of negative curvature. At the limit of iterations the
  /// last iterate, which is less accurate and still lowers the energy's quadratic model.
  [[nodiscard]] std::optional<Eigen::VectorXd> solve(const Eigen::VectorXd& right,
                                                     double accuracy);

  /// Unit vector of negative curvature of a tangent that is_definite found not to be
  /// positive definite: the direction on which it ended.
  [[nodiscard]] Eigen::VectorXd negative_curvature(std::mt19937_64& random);

  [[nodiscard]] int iterations() const { return iterations_; }  // all together

 private:
  struct Answer {
    Eigen::VectorXd solution;     // of all components
    Eigen::VectorXd direction{};  // the last one
    bool converged;
    bool definite;  // curvature positive along every direction
  };
  [[nodiscard]] Answer conjugate_gradients(const Eigen::VectorXd& right, double accuracy);
  [[nodiscard]] Eigen::VectorXd preconditioned(const Eigen::VectorXd& residual) const;
  void invert_blocks();
  [[nodiscard]] Eigen::VectorXd on_all(const Eigen::VectorXd& free) const;
  [[nodiscard]] Eigen::VectorXd on_free(const Eigen::VectorXd& all) const;

  int iteration_limit_;
  BlockTangent matrix_;
  std::vector<Eigen::Index> free_;
  std::vector<Matrix3> inverses_;  // of the blocks on the diagonal
  Eigen::VectorXd curvature_;      // the direction on which is_definite ended
  int iterations_ = 0;
};

}  // namespace springcheck::mss
