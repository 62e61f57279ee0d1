#include "statics/systems/iterative_solver.hpp"

#include <cmath>

#include "meshing/basics/random_vector.hpp"
#include "statics/systems/free_triangle.hpp"

namespace springcheck::statics {
namespace {

constexpr double definite_accuracy = 1e-6;
constexpr double stale = 1.5;  // times the iterations of a new preconditioner

}  // namespace

IterativeSolver::IterativeSolver(const BlockMatrix& matrix, const Unknowns& unknowns,
                                 std::unique_ptr<Preconditioner> preconditioner,
                                 int iteration_limit)
    : matrix_(matrix),
      unknowns_(unknowns),
      preconditioner_(std::move(preconditioner)),
      iteration_limit_(iteration_limit) {}

void IterativeSolver::prepare() {
  shift_ = 0;
  curvature_.resize(0);
  if (!has_preconditioner_ || !preconditioner_->lasts()) renew_preconditioner();
}

void IterativeSolver::prepare_semidefinite() {
  const bool fails = preconditioner_fails_;
  prepare();
  if (fails) renew_preconditioner();
  if (unknowns_.count() > 0) shift_ = 1e-8 * diagonal(matrix_, unknowns_).maxCoeff();
}

std::optional<bool> IterativeSolver::is_definite(std::mt19937_64& random) {
  Ending end =
      conjugate_gradients(random_vector(unknowns_.count(), random), definite_accuracy);
  curvature_ = std::move(end.direction);
  if (!end.definite) return false;
  if (!end.converged) return std::nullopt;
  if (!iterations_when_new_)
    iterations_when_new_ = end.iterations;
  else if (preconditioner_->lasts() && end.iterations > stale * *iterations_when_new_)
    renew_preconditioner();
  return true;
}

std::optional<IterativeSolver::Answer> IterativeSolver::solve(
    const Eigen::VectorXd& right, double accuracy) {
  const Ending end = conjugate_gradients(right, accuracy);
  if (!end.definite) return std::nullopt;
  return Answer{.solution = unknowns_.in(end.solution), .converged = end.converged};
}

Eigen::VectorXd IterativeSolver::negative_curvature(std::mt19937_64& random) {
  if (curvature_.size() == 0) (void)is_definite(random);
  return unknowns_.in(curvature_).normalized();
}

void IterativeSolver::renew_preconditioner() {
  preconditioner_->prepare(matrix_);
  has_preconditioner_ = true;
  preconditioner_fails_ = false;
  iterations_when_new_.reset();
}

IterativeSolver::Ending IterativeSolver::conjugate_gradients(const Eigen::VectorXd& right,
                                                             double accuracy) {
  Eigen::VectorXd residual = unknowns_.spread(right);
  Ending end{.solution = Eigen::VectorXd::Zero(residual.size()),
             .converged = false,
             .definite = true};
  Eigen::VectorXd z = preconditioner_->times(residual), product;
  Eigen::VectorXd& direction = end.direction = z;
  double squared = residual.dot(z);
  const double enough = accuracy * accuracy * squared;
  for (; end.iterations < iteration_limit_; ++end.iterations) {
    end.converged = squared >= 0 && squared <= enough;
    if (end.converged) return end;
    product_on_free(direction, product);
    ++iterations_;
    const double curvature = direction.dot(product);
    preconditioner_fails_ = !(squared > 0);
    end.definite = curvature > 0 && !preconditioner_fails_;
    if (!end.definite) return end;
    const double length = squared / curvature;
    end.solution += length * direction;
    residual -= length * product;
    z = preconditioner_->times(residual);
    const double before = squared;
    squared = residual.dot(z);
    direction = z + squared / before * direction;
  }
  return end;
}

void IterativeSolver::product_on_free(const Eigen::VectorXd& x,
                                      Eigen::VectorXd& product) const {
  matrix_.multiply(x, product);
  if (shift_ != 0) product += shift_ * x;
  unknowns_.clear_prescribed(product);
}

}  // namespace springcheck::statics
