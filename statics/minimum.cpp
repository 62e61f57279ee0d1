#include "statics/minimum.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace springcheck::statics {
namespace {

constexpr double relative_residual = 1e-10;
// Rounding that is larger than estimated keeps the residual from falling.
constexpr double stalled_residual = 1e-9;
constexpr int most_stalled = 5;
constexpr int newton_limit = 150;
constexpr double largest_move = 0.5;  // of a node in one iteration, in cell edges
constexpr double runaway_growth = 4;  // of the largest cell: there is no way back
constexpr double nearest_to_inversion = 1. / 64;  // of a step
constexpr double near_saddle = 1e-3;              // relative residual
constexpr double first_escape = 1e-3;  // along negative curvature, in cell edges

/// Newton's method is quadratic near the minimum: more digits than the next residual can
/// show are lost work.
double solver_accuracy(double residual) {
  return std::max(std::min(residual, 0.1), 0.2 * relative_residual / residual);
}

/// Moves along the direction of negative curvature, doubling the step while the energy
/// falls. False when it falls nowhere: the curvature is zero to round-off.
bool leave_saddle(PotentialEnergy& potential, PotentialEnergy::State& now,
                  const Eigen::VectorXd& downhill, std::mt19937_64& random) {
  Eigen::VectorXd direction = potential.negative_curvature(downhill, random);
  direction *= potential.body().cell_edge() / potential.longest_move(direction);
  bool fell = false;
  for (double step = first_escape; step <= largest_move; step *= 2) {
    PotentialEnergy::State trial =
        potential.at(potential.moved(now.displacements, step * direction));
    if (!(trial.energy < now.energy)) break;
    now = std::move(trial);
    fell = true;
  }
  return fell;
}

/// Moves to a state of less energy along the direction, by the whole of it or a part;
/// false where no part is found.
bool search_along(PotentialEnergy& potential, Minimum& minimum, Eigen::VectorXd step,
                  const Eigen::VectorXd& downhill) {
  const ElasticBody& body = potential.body();
  PotentialEnergy::State& now = minimum.state;
  const Eigen::VectorXd& u = now.displacements;
  if (!body.is_linear())
    step *= std::min(1., largest_move * body.cell_edge() / potential.longest_move(step));
  const double slope = downhill.dot(step);
  // Energy differences below round-off cannot be judged; the residual then decides.
  const double round_off = potential.energy_round_off(u, now.energy);
  double factor = 1;
  PotentialEnergy::State trial = potential.at(potential.moved(u, step));
  while (!(trial.energy <= now.energy - 1e-4 * factor * slope + round_off)) {
    factor /= 2;
    minimum.inverted = trial.energy == INFINITY;
    if (factor < (minimum.inverted ? nearest_to_inversion : 1e-8)) return false;
    trial = potential.at(potential.moved(u, factor * step));
  }
  now = std::move(trial);
  minimum.inverted = false;
  return true;
}

}  // namespace

Minimum minimise(PotentialEnergy& potential, Eigen::VectorXd start,
                 std::mt19937_64& random, Tangents tangents) {
  Minimum minimum{.state = potential.at(std::move(start)),
                  .found = false,
                  .definite = false,
                  .undecided = false,
                  .crossed = false,
                  .ran_away = false,
                  .inverted = false,
                  .residual = INFINITY,
                  .iterations = 0};
  const ElasticBody& body = potential.body();
  PotentialEnergy::State& now = minimum.state;
  const double runaway_ratio =
      runaway_growth * std::max(1., body.largest_volume_ratio(now.displacements));
  double lowest = INFINITY;  // residual
  int stalled = 0;           // iterations in which it has not fallen to half
  for (; minimum.iterations < newton_limit; ++minimum.iterations) {
    const Eigen::VectorXd& u = now.displacements;
    const Eigen::VectorXd downhill = potential.unknowns().in(now.forces);
    const double scale = std::max({now.forces.norm(), potential.load_norm(),
                                   potential.force_round_off(u) / relative_residual});
    const double residual = downhill.norm();
    minimum.residual = residual == 0 ? 0 : residual / scale;
    minimum.inverted = now.energy == INFINITY;
    if (!std::isfinite(minimum.residual) || !std::isfinite(now.energy)) return minimum;
    minimum.ran_away = body.largest_volume_ratio(u) > runaway_ratio;
    if (minimum.ran_away) return minimum;
    potential.linearise(u);
    stalled = minimum.residual < lowest / 2 ? 0 : stalled + 1;
    lowest = std::min(lowest, minimum.residual);
    minimum.found = minimum.residual < relative_residual ||
                    (minimum.residual < stalled_residual && stalled >= most_stalled);
    std::optional<Eigen::VectorXd> direction;
    if (minimum.found) {
      const std::optional<bool> definite = potential.is_definite(random);
      minimum.undecided = !definite;
      minimum.definite = definite.value_or(false);
    } else {
      direction = potential.solve(downhill, solver_accuracy(minimum.residual));
      minimum.definite = direction.has_value();
    }
    spdlog::debug("  newton {}: energy {:.9e}, residual {:.2e}{}", minimum.iterations,
                  now.energy, minimum.residual, minimum.definite ? "" : ", indefinite");
    if (minimum.found && (minimum.definite || minimum.undecided)) return minimum;
    if (!minimum.definite) minimum.crossed = true;
    if (minimum.crossed && tangents == Tangents::definite) {
      minimum.found = false;
      return minimum;
    }

    // Near a saddle the clamped tangent hardly moves along the unstable direction.
    if (!minimum.definite && minimum.residual < near_saddle) {
      if (leave_saddle(potential, now, downhill, random)) continue;
      if (minimum.found) return minimum;
    }
    if (!direction) {
      potential.clamp();
      direction = potential.solve(downhill, solver_accuracy(minimum.residual));
    }
    if (!direction || !search_along(potential, minimum, std::move(*direction), downhill))
      return minimum;
  }
  minimum.found = false;
  return minimum;
}

}  // namespace springcheck::statics
