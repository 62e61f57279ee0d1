#include "dynamics/marching/stable_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/marching/stable_step_near.hpp"

namespace springcheck::dynamics {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The largest eigenvalue, by Lanczos' recurrence. Without reorthogonalisation copies of
/// converged values appear, which does not move the largest one.
double largest_eigenvalue(const Combination& combination) {
  constexpr int iterations = 120;
  std::vector<double> diagonal, off_diagonal;
  Field v = combination.start(), previous = Field::Zero(v.size());
  double largest = -infinity;
  for (int i = 0; i < iterations; ++i) {
    Field w = combination.apply(v);
    const double alpha = w.dot(v);
    w -= alpha * v;
    if (!off_diagonal.empty()) w -= off_diagonal.back() * previous;
    diagonal.push_back(alpha);
    const double beta = w.norm();
    const bool last = beta <= 1e-10 * std::abs(alpha) || i + 1 == iterations;
    if (last || i % 10 == 9) {
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> tridiagonal;
      tridiagonal.computeFromTridiagonal(
          Eigen::Map<Eigen::VectorXd>(diagonal.data(),
                                      static_cast<Eigen::Index>(diagonal.size())),
          Eigen::Map<Eigen::VectorXd>(off_diagonal.data(),
                                      static_cast<Eigen::Index>(off_diagonal.size())),
          Eigen::EigenvaluesOnly);
      const double now = tridiagonal.eigenvalues().maxCoeff();
      const double spread = tridiagonal.eigenvalues().cwiseAbs().maxCoeff();
      if (last || now - largest < 1e-6 * spread) return now;
      largest = now;
    }
    off_diagonal.push_back(beta);
    previous = std::move(v);
    v = w / beta;
  }
  return largest;
}

double largest_eigenvalue(const SmallMotions& system, double stiffness_factor,
                          double dashpot_factor) {
  return largest_eigenvalue(Combination(system, stiffness_factor, dashpot_factor));
}

/// The largest value up to `high` for which holds(dt) is true, to 1e-4; it is true for
/// all smaller ones.
template <class Holds>
double bisected(double high, const Holds& holds) {
  if (holds(high)) return high;
  double low = 0;
  while (high - low > 1e-4 * high) {
    const double middle = (low + high) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

/// dt with lambda(dt) = 4 of dt^2 K + 2 dt C, by parabolas a dt^2 + b dt through the last
/// value: lambda is the largest of such parabolas.
double semi_implicit_limit(const SmallMotions& system, double undamped) {
  const double a = 4 / (undamped * undamped);
  double dt = undamped;
  for (int i = 0; i < 20; ++i) {
    const double b =
        std::max(0., largest_eigenvalue(system, dt * dt, 2 * dt) / dt - a * dt);
    const double next = (-b + std::sqrt(b * b + 16 * a)) / (2 * a);
    const bool settled = std::abs(next - dt) < 3e-5 * dt;
    dt = next;
    if (settled) break;
  }
  return dt;
}

/// Whether explicit Euler's conditions hold for a step.
class ExplicitConditions {
 public:
  explicit ExplicitConditions(const SmallMotions& system)
      : system_(system), rate_(largest_eigenvalue(system, 0, 1)) {}

  [[nodiscard]] double rate() const { return rate_; }  // largest c/m
  [[nodiscard]] bool hold(double dt) const {
    return largest_eigenvalue(system_, dt, -1) <= tolerance_ &&
           largest_eigenvalue(system_, -dt * dt, 2 * dt) <= 4;
  }
  /// Whether every direction is damped. Along one without dashpots the tolerance alone
  /// lets a step pass, and half the step uses up half of it.
  [[nodiscard]] bool all_is_damped(double dt) const {
    return largest_eigenvalue(system_, dt / 2, -1) < tolerance_ / 4;
  }

 private:
  const SmallMotions& system_;
  double rate_, tolerance_ = 1e-6 * rate_;
};

double explicit_limit(const SmallMotions& system, double undamped) {
  const ExplicitConditions conditions(system);
  if (!(conditions.rate() > 0)) return 0;
  // The limit of a single mode is c/k. No step above that of the softest direction is
  // asked about.
  const double high = std::min(2 / conditions.rate(), undamped);
  const double limit = bisected(high, [&](double dt) { return conditions.hold(dt); });
  return conditions.all_is_damped(limit) ? limit : 0;
}

/// The same where the limit was `known`, in strides of 5 % on the safe side; a limit that
/// is 0 stays so.
double explicit_limit_near(const SmallMotions& system, double known) {
  constexpr double stride = 1.05;
  if (!system.has_dashpots || known == 0) return 0;
  const ExplicitConditions conditions(system);
  if (!(conditions.rate() > 0)) return 0;
  double dt = known;
  if (conditions.hold(dt)) {
    for (int i = 0; i < 10 && conditions.hold(stride * dt); ++i) dt *= stride;
  } else {
    constexpr double lost = 0.01;  // of what it was
    do {
      dt /= stride * stride;
      if (dt < lost * known) return 0;
    } while (!conditions.hold(dt));
  }
  return conditions.all_is_damped(dt) ? dt : 0;
}

StableStep found_near(const SmallMotions& system, Integrator integrator,
                      const StableStep& known) {
  if (integrator == Integrator::implicit_euler || !std::isfinite(known.limit))
    return {.limit = largest_stable_step(system, integrator)};
  if (integrator == Integrator::explicit_euler)
    return {.limit = explicit_limit_near(system, known.limit)};
  return stable_step_near(system, known);
}

}  // namespace

double largest_stable_step(const SmallMotions& system, Integrator integrator) {
  if (integrator == Integrator::implicit_euler ||
      std::ranges::none_of(system.is_free, std::identity{}))
    return infinity;
  const double square_frequency = largest_eigenvalue(system, 1, 0);
  if (!(square_frequency > 0)) return infinity;
  const double undamped = 2 / std::sqrt(square_frequency);
  if (integrator == Integrator::explicit_euler)
    return system.has_dashpots ? explicit_limit(system, undamped) : 0;
  return system.has_dashpots ? semi_implicit_limit(system, undamped) : undamped;
}

StableStep largest_stable_step(SmallMotions system, Motion& motion, Precision precision,
                               const std::optional<State>& state, Integrator integrator,
                               const StableStep* near) {
  constexpr double single_over_double = 100;  // what a float can tell from rounding
  if (precision == Precision::single_precision) system.amplitude *= single_over_double;
  if (state) system.state = *state;
  int evaluations = 0;
  system.forces = [&](const State& at) {
    ++evaluations;
    return motion.forces_at(at);
  };
  StableStep found = near == nullptr
                         ? StableStep{.limit = largest_stable_step(system, integrator)}
                         : found_near(system, integrator, *near);
  motion.restore(system.state);
  found.force_evaluations = evaluations;
  return found;
}

}  // namespace springcheck::dynamics
