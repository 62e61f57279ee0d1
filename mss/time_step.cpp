#include "mss/time_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "mss/cell.hpp"
#include "mss/forces.hpp"

namespace springcheck::mss {
namespace {

using Field = Eigen::Matrix3Xd;  // a vector per node

/// v -> M^-1/2 (2 dt C + dt^2 K) M^-1/2 v at rest, on the free components.
class StepOperator {
 public:
  StepOperator(const Network& network, double damping_ratio,
               const std::vector<bool>& is_free)
      : network_(network),
        inverse_root_mass_(3, static_cast<Eigen::Index>(network.masses.size())) {
    for (std::size_t i = 0; i < is_free.size(); ++i)
      inverse_root_mass_.reshaped()[static_cast<Eigen::Index>(i)] =
          is_free[i] ? 1 / std::sqrt(network.masses[i / 3]) : 0;
    for (const Spring& spring : network.springs) {
      axes_.push_back(
          (network.rest_positions[spring.b] - network.rest_positions[spring.a])
              .normalized());
      dashpots_.push_back(dashpot_constant(network, spring, damping_ratio));
    }
    if (network.volume_modulus != 0)
      for (const Cell& cell : network.cells)
        gradients_.push_back(
            mean_edge_volume_gradient(corners(cell.nodes, network.rest_positions)));
  }

  [[nodiscard]] Field start() const {
    std::mt19937_64 random(1);  // any vector not orthogonal to the answer
    Field v = Field::Zero(3, inverse_root_mass_.cols());
    for (Eigen::Index n = 0; n < v.cols(); ++n)
      for (Eigen::Index i = 0; i < 3; ++i)
        if (inverse_root_mass_(i, n) != 0)
          v(i, n) = static_cast<double>(random() >> 11U) * 0x1p-52 - 1;
    return v / v.norm();
  }

  [[nodiscard]] Field apply(const Field& v, double dt) const {
    const Field u = v.cwiseProduct(inverse_root_mass_);
    Field force = Field::Zero(3, v.cols());
    for (std::size_t s = 0; s < axes_.size(); ++s) {
      const Spring& spring = network_.springs[s];
      const double weight = dt * dt * spring.stiffness + 2 * dt * dashpots_[s];
      const Vector3 pull =
          weight * axes_[s].dot(u.col(spring.b) - u.col(spring.a)) * axes_[s];
      force.col(spring.a) -= pull;
      force.col(spring.b) += pull;
    }
    for (std::size_t c = 0; c < gradients_.size(); ++c) {
      const Cell& cell = network_.cells[c];
      double volume_rate = 0;
      for (std::size_t i = 0; i < 8; ++i)
        volume_rate +=
            gradients_[c].col(static_cast<Eigen::Index>(i)).dot(u.col(cell.nodes[i]));
      const double pressure =
          dt * dt * network_.volume_modulus / cell.rest_volume * volume_rate;
      for (std::size_t i = 0; i < 8; ++i)
        force.col(cell.nodes[i]) +=
            pressure * gradients_[c].col(static_cast<Eigen::Index>(i));
    }
    return force.cwiseProduct(inverse_root_mass_);
  }

 private:
  const Network& network_;
  Field inverse_root_mass_;  // 0 in prescribed components
  std::vector<Vector3> axes_;
  std::vector<double> dashpots_;
  std::vector<Eigen::Matrix<double, 3, 8>> gradients_;
};

/// Largest eigenvalue by Lanczos' recurrence; without reorthogonalisation copies of
/// converged values appear, which does not move the largest one.
double largest_eigenvalue(const StepOperator& step_operator, double dt) {
  constexpr int iterations = 120;
  std::vector<double> diagonal, off_diagonal;
  Field v = step_operator.start(), previous = Field::Zero(3, v.cols());
  double largest = 0;
  for (int i = 0; i < iterations; ++i) {
    Field w = step_operator.apply(v, dt);
    const double alpha = w.cwiseProduct(v).sum();
    w -= alpha * v;
    if (!off_diagonal.empty()) w -= off_diagonal.back() * previous;
    diagonal.push_back(alpha);
    const double beta = w.norm();
    const bool last = beta < 1e-14 * std::abs(alpha) || i + 1 == iterations;
    if (last || i % 10 == 9) {
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> tridiagonal;
      tridiagonal.computeFromTridiagonal(
          Eigen::Map<Eigen::VectorXd>(diagonal.data(),
                                      static_cast<Eigen::Index>(diagonal.size())),
          Eigen::Map<Eigen::VectorXd>(off_diagonal.data(),
                                      static_cast<Eigen::Index>(off_diagonal.size())),
          Eigen::EigenvaluesOnly);
      const double now = tridiagonal.eigenvalues().maxCoeff();
      if (last || now - largest < 1e-6 * now) return now;
      largest = now;
    }
    off_diagonal.push_back(beta);
    previous = std::move(v);
    v = w / beta;
  }
  return largest;
}

}  // namespace

double largest_stable_step(const Network& network, double damping_ratio,
                           const std::vector<bool>& is_free) {
  if (std::ranges::none_of(is_free, std::identity{}))
    return std::numeric_limits<double>::infinity();  // nothing can swing
  const double square_frequency =
      largest_eigenvalue(StepOperator(network, 0, is_free), 1);
  if (!(square_frequency > 0)) return std::numeric_limits<double>::infinity();
  const double undamped = 2 / std::sqrt(square_frequency);
  if (damping_ratio == 0) return undamped;
  // Dashpots only shorten the step, and the eigenvalue grows with dt: bisection.
  const StepOperator step_operator(network, damping_ratio, is_free);
  double low = 0, high = undamped;
  while (high - low > 1e-4 * high) {
    const double dt = (low + high) / 2;
    (largest_eigenvalue(step_operator, dt) < 4 ? low : high) = dt;
  }
  return low;
}

}  // namespace springcheck::mss
