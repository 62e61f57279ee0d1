#include "dynamics/stable_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace springcheck::dynamics {
namespace {

using Field = Eigen::VectorXd;  // an entry per free component

constexpr double infinity = std::numeric_limits<double>::infinity();

/// v -> M^-1/2 (stiffness_factor K + dashpot_factor C) M^-1/2 v on the free components.
class Combination {
 public:
  Combination(const SmallMotions& system, double stiffness_factor, double dashpot_factor)
      : system_(system), stiffness_(stiffness_factor), dashpots_(dashpot_factor) {
    for (std::size_t i = 0; i < system.is_free.size(); ++i)
      if (system.is_free[i]) components_.push_back(i);
    inverse_root_mass_.resize(static_cast<Eigen::Index>(components_.size()));
    for (std::size_t n = 0; n < components_.size(); ++n)
      inverse_root_mass_[static_cast<Eigen::Index>(n)] =
          1 / std::sqrt(system.masses[components_[n] / 3]);
  }

  [[nodiscard]] Field start() const {
    std::mt19937_64 random(1);  // any vector not orthogonal to the answer
    Field v(inverse_root_mass_.size());
    for (double& component : v)
      component = static_cast<double>(random() >> 11U) * 0x1p-52 - 1;
    return v / v.norm();
  }

  /// One pair of forces gives both: displacements move along the vector where K counts,
  /// velocities in proportion.
  [[nodiscard]] Field apply(const Field& v) const {
    const Field u = v.cwiseProduct(inverse_root_mass_);
    const double scale = system_.amplitude / u.cwiseAbs().maxCoeff();
    const double moved = stiffness_ == 0 ? 0 : scale;
    const double pushed = stiffness_ == 0 ? scale : scale * dashpots_ / stiffness_;
    const auto ahead = system_.forces(at(u, moved, pushed)),
               behind = system_.forces(at(u, -moved, -pushed));
    const double factor = (stiffness_ == 0 ? dashpots_ : stiffness_) / (2 * scale);
    Field result(v.size());
    for (std::size_t n = 0; n < components_.size(); ++n) {
      const std::size_t node = components_[n] / 3;
      const auto i = static_cast<Eigen::Index>(components_[n] % 3);
      result[static_cast<Eigen::Index>(n)] = factor * (behind[node][i] - ahead[node][i]);
    }
    return result.cwiseProduct(inverse_root_mass_);
  }

 private:
  [[nodiscard]] State at(const Field& u, double moved, double pushed) const {
    State state = system_.state;
    for (std::size_t n = 0; n < components_.size(); ++n) {
      const std::size_t node = components_[n] / 3;
      const auto i = static_cast<Eigen::Index>(components_[n] % 3);
      state.displacements[node][i] += moved * u[static_cast<Eigen::Index>(n)];
      state.velocities[node][i] += pushed * u[static_cast<Eigen::Index>(n)];
    }
    return state;
  }

  const SmallMotions& system_;
  double stiffness_, dashpots_;
  std::vector<std::size_t> components_;
  Field inverse_root_mass_;
};

/// By Lanczos' recurrence; without reorthogonalisation copies of converged values appear,
/// which does not move the largest one.
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

/// The largest value up to `high` with holds(dt), which holds below it, to 1e-4.
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

double explicit_limit(const SmallMotions& system, double undamped) {
  const double rate = largest_eigenvalue(system, 0, 1);  // largest c/m
  if (!(rate > 0)) return 0;
  const double tolerance = 1e-6 * rate;
  // Of a single mode c/k; no step above that of the softest direction is asked about.
  const double high = std::min(2 / rate, undamped);
  const double limit = bisected(high, [&](double dt) {
    return largest_eigenvalue(system, dt, -1) <= tolerance &&
           largest_eigenvalue(system, -dt * dt, 2 * dt) <= 4;
  });
  // Along a direction without dashpots the tolerance alone lets a step pass, and half the
  // step uses up half of it.
  return largest_eigenvalue(system, limit / 2, -1) < tolerance / 4 ? limit : 0;
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

double largest_stable_step(SmallMotions system, Motion& motion, Precision precision,
                           const std::optional<State>& state, Integrator integrator) {
  constexpr double single_over_double = 100;  // what a float can tell from rounding
  if (precision == Precision::single_precision) system.amplitude *= single_over_double;
  if (state) system.state = *state;
  system.forces = [&](const State& at) { return motion.forces_at(at); };
  const double limit = largest_stable_step(system, integrator);
  motion.restore(system.state);
  return limit;
}

}  // namespace springcheck::dynamics
