#include "mss/time_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "mss/assembly.hpp"
#include "mss/forces.hpp"

namespace springcheck::mss {
namespace {

using Field = Eigen::VectorXd;  // an entry per free component

/// v -> M^-1/2 (2 dt C + dt^2 K) M^-1/2 v at rest, on the free components.
class StepOperator {
 public:
  StepOperator(const Network& network, double damping_ratio,
               const std::vector<bool>& is_free)
      : assembly_(network, is_free),
        stiffness_(assembly_.assemble(tangent_at(network, network.rest_positions))),
        inverse_root_mass_(assembly_.size()) {
    for (NodeIndex n = 0; n < network.masses.size(); ++n)
      for (int i = 0; i < 3; ++i)
        if (const Eigen::Index unknown = assembly_.unknown(n, i); unknown >= 0)
          inverse_root_mass_[unknown] = 1 / std::sqrt(network.masses[n]);
    if (damping_ratio == 0) return;
    for_each_dashpot(network, [&](const Spring& spring) {
      dashpots_.push_back(
          {.a = spring.a,
           .b = spring.b,
           .axis = (network.rest_positions[spring.b] - network.rest_positions[spring.a])
                       .normalized(),
           .constant = dashpot_constant(network, spring, damping_ratio)});
    });
  }

  [[nodiscard]] Field start() const {
    std::mt19937_64 random(1);  // any vector not orthogonal to the answer
    Field v(assembly_.size());
    for (double& component : v)
      component = static_cast<double>(random() >> 11U) * 0x1p-52 - 1;
    return v / v.norm();
  }

  [[nodiscard]] Field apply(const Field& v, double dt) const {
    const Field u = v.cwiseProduct(inverse_root_mass_);
    Field force = stiffness_.selfadjointView<Eigen::Lower>() * u;
    force *= dt * dt;
    for (const auto& [a, b, axis, constant] : dashpots_) {
      double approach = 0;
      for_each_end(a, b, [&](Eigen::Index unknown, int i, double sign) {
        approach += sign * axis[i] * u[unknown];
      });
      for_each_end(a, b, [&](Eigen::Index unknown, int i, double sign) {
        force[unknown] += sign * 2 * dt * constant * approach * axis[i];
      });
    }
    return force.cwiseProduct(inverse_root_mass_);
  }

 private:
  struct Dashpot {
    NodeIndex a, b;
    Vector3 axis;
    double constant;  // [N s/m]
  };

  /// visit(unknown, component, -1 at a and 1 at b) for the free components of both.
  template <class Visit>
  void for_each_end(NodeIndex a, NodeIndex b, Visit&& visit) const {
    for (int i = 0; i < 3; ++i) {
      if (const Eigen::Index unknown = assembly_.unknown(a, i); unknown >= 0)
        visit(unknown, i, -1.);
      if (const Eigen::Index unknown = assembly_.unknown(b, i); unknown >= 0)
        visit(unknown, i, 1.);
    }
  }

  FreeAssembly assembly_;
  const Eigen::SparseMatrix<double>& stiffness_;
  Field inverse_root_mass_;
  std::vector<Dashpot> dashpots_;
};

/// Largest eigenvalue by Lanczos' recurrence; without reorthogonalisation copies of
/// converged values appear, which does not move the largest one.
double largest_eigenvalue(const StepOperator& step_operator, double dt) {
  constexpr int iterations = 120;
  std::vector<double> diagonal, off_diagonal;
  Field v = step_operator.start(), previous = Field::Zero(v.size());
  double largest = 0;
  for (int i = 0; i < iterations; ++i) {
    Field w = step_operator.apply(v, dt);
    const double alpha = w.dot(v);
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
