#include "dynamics/marching/stable_step_near.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

namespace springcheck::dynamics {
namespace {

constexpr double noise = 0.1;
constexpr int fewest_ascents = 5;  // for the noise to grow
constexpr int most_ascents = 40;
constexpr double settled_to = 1e-3;  // of the eigenvalue, in an ascent

/// A direction and what the operator makes of it.
struct Pair {
  Field v, image;

  void operator*=(double factor) {
    v *= factor;
    image *= factor;
  }
  void add(double factor, const Pair& other) {
    v += factor * other.v;
    image += factor * other.image;
  }
};

/// Makes `pair` of length 1 and orthogonal to a unit vector; nothing left: false.
bool make_orthogonal(Pair& pair, const Pair& unit) {
  const double before = pair.v.norm();
  pair.add(-pair.v.dot(unit.v), unit);
  const double left = pair.v.norm();
  if (!(left > 1e-6 * before)) return false;
  pair *= 1 / left;
  return true;
}

struct Mode {
  double eigenvalue;
  Field v;  // of length 1
};

Mode stiffest_near(const Combination& combination, const Field& start) {
  Pair here{start / start.norm(), {}}, last{};
  here.image = combination.apply(here.v);
  double eigenvalue = here.v.dot(here.image);
  for (int i = 0; i < most_ascents; ++i) {
    Pair uphill{here.image - eigenvalue * here.v, {}};
    const double steepness = uphill.v.norm();
    if (!(steepness > 1e-10 * std::abs(eigenvalue))) break;  // or no numbers
    uphill.v /= steepness;
    uphill.image = combination.apply(uphill.v);
    const bool has_last =
        i > 0 && make_orthogonal(last, here) && make_orthogonal(last, uphill);
    const Eigen::Index n = has_last ? 3 : 2;
    const Pair* const basis[] = {&here, &uphill, &last};
    Eigen::MatrixXd small(n, n);
    for (Eigen::Index a = 0; a < n; ++a)
      for (Eigen::Index b = 0; b < n; ++b) small(a, b) = basis[a]->v.dot(basis[b]->image);
    if (!small.allFinite()) break;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(
        (small + small.transpose()) / 2);
    const Eigen::VectorXd best = ritz.eigenvectors().col(n - 1);
    uphill *= best[1];
    if (has_last) uphill.add(best[2], last);
    last = std::move(uphill);
    here *= best[0];
    here.add(1, last);
    here *= 1 / here.v.norm();
    const double before = eigenvalue;
    eigenvalue = here.v.dot(here.image);
    if (i + 1 >= fewest_ascents &&
        eigenvalue - before < settled_to * std::abs(eigenvalue))
      break;
  }
  return {eigenvalue, std::move(here.v)};
}

Field free_part(const SmallMotions& system, const std::vector<double>& all,
                Eigen::Index size) {
  Field part(size);
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (system.is_free[i]) part[next++] = all[i];
  return part;
}

std::vector<double> with_held(const SmallMotions& system, const Field& part) {
  std::vector<double> all(system.is_free.size(), 0);
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (system.is_free[i]) all[i] = part[next++];
  return all;
}

}  // namespace

StableStep stable_step_near(const SmallMotions& system, const StableStep& known) {
  const Combination stiffness(system, 1, 0);
  Field start = stiffness.start();
  if (!known.mode.empty())
    start = free_part(system, known.mode, start.size()) + noise * start;
  if (!system.has_dashpots) {
    Mode mode = stiffest_near(stiffness, start);
    const double limit = mode.eigenvalue <= 0 ? std::numeric_limits<double>::infinity()
                                              : 2 / std::sqrt(mode.eigenvalue);
    return {.limit = limit, .mode = with_held(system, mode.v)};
  }
  // The largest eigenvalue of dt^2 K + 2 dt C at the known limit is the parabola a dt^2 +
  // 2 b dt of a motion, which is 4 near the limit here.
  double dt = known.limit;
  for (int i = 0;; ++i) {
    Mode mode = stiffest_near(Combination(system, dt * dt, 2 * dt), start);
    const double a = mode.v.dot(stiffness.apply(mode.v));
    const double b = (mode.eigenvalue / dt - a * dt) / 2;
    const double root = std::sqrt(b * b + 4 * a);  // of no number where there is none
    const double next = 4 / (b + root);
    const bool settled = std::abs(next - dt) < 0.05 * dt;
    dt = b + root > 0 ? next : std::numeric_limits<double>::infinity();
    if (settled || !std::isfinite(dt) || i == 5)
      return {.limit = dt, .mode = with_held(system, mode.v)};
    start = std::move(mode.v);
  }
}

}  // namespace springcheck::dynamics
