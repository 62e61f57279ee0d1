#include "mss/statics/iterative_solver.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "meshing/random_vector.hpp"

namespace springcheck::mss {
namespace {

constexpr double definite_accuracy = 1e-6;

}  // namespace

IterativeSolver::IterativeSolver(const Network& network, const std::vector<bool>& is_free,
                                 int iteration_limit)
    : iteration_limit_(iteration_limit),
      matrix_(network, is_free),
      inverses_(matrix_.nodes()) {
  for (std::size_t i = 0; i < is_free.size(); ++i)
    if (is_free[i]) free_.push_back(static_cast<Eigen::Index>(i));
}

void IterativeSolver::prepare(const Tangent& tangent) {
  matrix_.assemble(tangent);
  invert_blocks();
}

void IterativeSolver::prepare_clamped(const Tangent& tangent) {
  matrix_.assemble(tangent);
  double largest = 0;
  for (NodeIndex n = 0; n < matrix_.nodes(); ++n)
    largest = std::max(largest, matrix_.diagonal(n).diagonal().maxCoeff());
  matrix_.shift(1e-8 * largest);
  invert_blocks();
}

std::optional<bool> IterativeSolver::is_definite(std::mt19937_64& random) {
  const Eigen::VectorXd right =
      random_vector(static_cast<Eigen::Index>(free_.size()), random);
  Answer answer = conjugate_gradients(on_all(right), definite_accuracy);
  curvature_ = std::move(answer.direction);
  if (!answer.converged && answer.definite) return std::nullopt;
  return answer.definite;
}

std::optional<Eigen::VectorXd> IterativeSolver::solve(const Eigen::VectorXd& right,
                                                      double accuracy) {
  const Answer answer = conjugate_gradients(on_all(right), accuracy);
  if (!answer.definite) return std::nullopt;
  return on_free(answer.solution);
}

Eigen::VectorXd IterativeSolver::negative_curvature(std::mt19937_64& random) {
  if (curvature_.size() == 0) (void)is_definite(random);
  return on_free(curvature_).normalized();
}

IterativeSolver::Answer IterativeSolver::conjugate_gradients(const Eigen::VectorXd& right,
                                                             double accuracy) {
  Answer answer{.solution = Eigen::VectorXd::Zero(right.size()),
                .converged = false,
                .definite = true};
  Eigen::VectorXd residual = right, product;
  Eigen::VectorXd z = preconditioned(residual);
  Eigen::VectorXd& direction = answer.direction = z;
  double squared = residual.dot(z);
  const double enough = accuracy * accuracy * squared;
  for (int i = 0; i < iteration_limit_; ++i) {
    answer.converged = squared <= enough;
    if (answer.converged) return answer;
    matrix_.multiply(direction, product);
    ++iterations_;
    const double curvature = direction.dot(product);
    answer.definite = curvature > 0;
    if (!answer.definite) return answer;
    const double length = squared / curvature;
    answer.solution += length * direction;
    residual -= length * product;
    z = preconditioned(residual);
    const double before = squared;
    squared = residual.dot(z);
    direction = z + squared / before * direction;
  }
  return answer;
}

Eigen::VectorXd IterativeSolver::preconditioned(const Eigen::VectorXd& residual) const {
  Eigen::VectorXd z(residual.size());
  for (std::size_t n = 0; n < inverses_.size(); ++n) {
    const auto row = 3 * static_cast<Eigen::Index>(n);
    z.segment<3>(row).noalias() = inverses_[n] * residual.segment<3>(row);
  }
  return z;
}

void IterativeSolver::invert_blocks() {
  curvature_.resize(0);
  tbb::parallel_for(std::size_t{0}, inverses_.size(), [&](std::size_t n) {
    Matrix3 block = matrix_.diagonal(static_cast<NodeIndex>(n));
    for (std::size_t i = 0; i < 3; ++i)
      if (!matrix_.is_free()[3 * n + i]) {
        const auto at = static_cast<Eigen::Index>(i);
        block(at, at) = 1;
      }
    const Eigen::SelfAdjointEigenSolver<Matrix3> spectrum(block);
    const Vector3 sizes = spectrum.eigenvalues().cwiseAbs();
    const double least = 1e-12 * sizes.maxCoeff();
    const Matrix3& axes = spectrum.eigenvectors();
    inverses_[n] =
        axes * sizes.cwiseMax(least).cwiseInverse().asDiagonal() * axes.transpose();
  });
}

Eigen::VectorXd IterativeSolver::on_all(const Eigen::VectorXd& free) const {
  Eigen::VectorXd all =
      Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(inverses_.size()));
  for (std::size_t i = 0; i < free_.size(); ++i)
    all[free_[i]] = free[static_cast<Eigen::Index>(i)];
  return all;
}

Eigen::VectorXd IterativeSolver::on_free(const Eigen::VectorXd& all) const {
  Eigen::VectorXd free(static_cast<Eigen::Index>(free_.size()));
  for (std::size_t i = 0; i < free_.size(); ++i)
    free[static_cast<Eigen::Index>(i)] = all[free_[i]];
  return free;
}

}  // namespace springcheck::mss
