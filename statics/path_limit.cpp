#include "statics/path_limit.hpp"

#include <spdlog/spdlog.h>

#include <cmath>
#include <deque>
#include <random>

#include "meshing/basics/random_vector.hpp"
#include "statics/potential_energy.hpp"

namespace springcheck::statics {
namespace {

constexpr double path_residual = 1e-9;
constexpr int most_corrections = 12;    // quadratic convergence takes five or six
constexpr double longest_move = 0.5;    // of a node in one correction, in cell edges
constexpr double first_step = 1. / 16;  // of the load
constexpr double finest = 1e-6;         // difference of loads, of the load
constexpr double small = 0.1;           // a curvature over that at rest
constexpr double earlier = 1. / 32;     // of the load, in which a curvature changes much
constexpr unsigned seed = 1;  // of where iterations start that end at the same place

/// The equilibrium that Newton's method leads to with the true tangent, or nothing where
/// a tangent on the way is not positive definite, a residual is not finite, or it does
/// not get there in a few corrections. `potential` then has the equilibrium's tangent.
std::optional<PotentialEnergy::State> corrected(PotentialEnergy& potential,
                                                Eigen::VectorXd u,
                                                std::mt19937_64& random) {
  for (int i = 0; i < most_corrections; ++i) {
    PotentialEnergy::State now = potential.at(std::move(u));
    const Eigen::VectorXd downhill = potential.unknowns().in(now.forces);
    const double scale = std::max(
        now.forces.norm(), potential.force_round_off(now.displacements) / path_residual);
    const double residual = downhill.norm() / scale;
    if (!std::isfinite(residual)) return std::nullopt;
    potential.linearise(now.displacements);
    if (residual < path_residual) {
      if (!potential.is_definite(random).value_or(false)) return std::nullopt;
      return now;
    }
    const auto step = potential.solve(downhill, std::min(1e-3, residual));
    if (!step ||
        potential.longest_move(*step) > longest_move * potential.body().cell_edge())
      return std::nullopt;
    u = potential.moved(now.displacements, *step);
  }
  return std::nullopt;
}

struct Mode {
  Eigen::VectorXd shape{};
  double curvature = 0;
};

/// The least curvature of the tangent taken last, positive definite, by inverse iteration
/// until it changes by less than that part of itself.
Mode least_curvature(PotentialEnergy& potential, std::mt19937_64& random, double change) {
  constexpr int most_iterations = 200;
  Mode mode{.shape = random_vector(potential.unknowns().count(), random).normalized(),
            .curvature = 0};
  for (int i = 0; i < most_iterations; ++i) {
    const Eigen::VectorXd image = potential.solve(mode.shape, 1e-6).value();
    const double curvature = 1 / mode.shape.dot(image);
    const bool settled = std::abs(curvature - mode.curvature) < change * curvature;
    mode.curvature = curvature;
    mode.shape = image.normalized();
    if (settled) break;
  }
  return mode;
}

/// A state of the path.
struct Passed {
  double load_fraction;
  Eigen::VectorXd displacements;
};

/// How a path goes on along a mode.
struct Along {
  double amplitude;  // of the mode in du/ds, on the unknowns
  double part;       // of du/ds
  double curvature;  // of the energy
};

Along along(PotentialEnergy& potential, const Passed& state,
            const Eigen::VectorXd& mode) {
  constexpr double little = 1e-6;  // of the load
  potential.set_load(state.load_fraction);
  potential.linearise(state.displacements);
  const Eigen::VectorXd way = potential.unknowns().in(
      potential.predicted(state.displacements, state.load_fraction + little) -
      state.displacements);
  const double amplitude = std::abs(mode.dot(way));
  return {.amplitude = amplitude / little,
          .part = amplitude / way.norm(),
          .curvature = potential.curvature_along(mode)};
}

/// Whether du/ds grows along the mode as its curvature falls from an earlier state to the
/// last: by more than the curvature's root does, which is half way between staying and
/// growing like its inverse. A smaller part than a hundredth is an imperfection's, or
/// round-off.
bool turns_back(PotentialEnergy& potential, const Passed& earlier, const Passed& last,
                const Eigen::VectorXd& mode) {
  constexpr double least_part = 0.01;
  const Along before = along(potential, earlier, mode),
              now = along(potential, last, mode);
  return now.part > least_part && now.amplitude * std::sqrt(now.curvature) >
                                      before.amplitude * std::sqrt(before.curvature);
}

PathLimit at_rest(PotentialEnergy& potential) {
  const Eigen::VectorXd rest =
      Eigen::VectorXd::Zero(3 * std::ssize(potential.body().nodes()));
  return {.end = PathEnd::full_load,
          .load_fraction = 0,
          .next_load_fraction = 1,
          .state = potential.at(rest),
          .critical_mode = rest,
          .curvature = 0,
          .rest_curvature = 0,
          .mode_rest_curvature = 0,
          .steps = 0};
}

/// Tells how a path ended short of its load, with the mode that is least stable there.
void set_end(PathLimit& limit, PotentialEnergy& potential, const Mode& mode,
             bool was_rejected, const std::deque<Passed>& passed) {
  limit.curvature = mode.curvature;
  limit.critical_mode = potential.unknowns().spread(mode.shape);
  potential.linearise(Eigen::VectorXd::Zero(limit.state.displacements.size()));
  limit.mode_rest_curvature = potential.curvature_along(mode.shape);
  if (was_rejected)
    limit.end = PathEnd::rejected;
  else if (mode.curvature > small * limit.mode_rest_curvature)
    limit.end = PathEnd::solver;
  else
    limit.end = turns_back(potential, passed.front(), passed.back(), mode.shape)
                    ? PathEnd::limit_point
                    : PathEnd::bifurcation;
}

}  // namespace

PathLimit follow_to_limit(PotentialEnergy& potential, double resolution,
                          const AcceptState& accept) {
  std::mt19937_64 random(seed);
  PathLimit limit = at_rest(potential);
  const Eigen::VectorXd rest = limit.state.displacements;
  potential.linearise(rest);
  // Where conjugate gradients cannot tell whether rest is stable, the path's first step
  // shows it.
  if (!potential.is_definite(random).value_or(true)) {
    limit.end = PathEnd::bifurcation;
    limit.next_load_fraction = 0;
    const Eigen::VectorXd downhill = Eigen::VectorXd::Ones(potential.unknowns().count());
    limit.critical_mode =
        potential.unknowns().spread(potential.negative_curvature(downhill, random));
    return limit;
  }
  const double whole = potential.path_gradient(potential.predicted(rest, 1));
  const double longest_step = std::min(first_step, first_gradient / whole);
  Mode mode;
  const auto find_mode = [&] {
    if (limit.rest_curvature == 0) {
      potential.linearise(rest);
      limit.rest_curvature = least_curvature(potential, random, 1e-3).curvature;
    }
    potential.set_load(limit.load_fraction);
    potential.linearise(limit.state.displacements);
    mode = least_curvature(potential, random, 1e-6);
  };
  bool was_rejected = false;
  std::deque<Passed> passed{{.load_fraction = 0, .displacements = rest}};
  constexpr double none = 2;
  double failed = none;  // the lowest load that was tried and not reached
  for (double step = longest_step; limit.load_fraction < 1;) {
    const double to = std::min(1., limit.load_fraction + step);
    potential.linearise(limit.state.displacements);
    potential.set_load(limit.load_fraction);
    const Eigen::VectorXd start = potential.predicted(limit.state.displacements, to);
    potential.set_load(to);
    std::optional<PotentialEnergy::State> state = corrected(potential, start, random);
    was_rejected = state && !accept(state->displacements, to);
    spdlog::debug("load {:.6f}: {}", to,
                  was_rejected ? "not accepted"
                  : state      ? "stable"
                               : "not reached");
    if (state && !was_rejected) {
      limit.state = std::move(*state);
      limit.load_fraction = to;
      ++limit.steps;
      passed.push_back({to, limit.state.displacements});
      while (passed.size() > 1 && passed[1].load_fraction <= (1 - earlier) * to)
        passed.pop_front();
      // What a long step failed at is tried again by a shorter one.
      if (to >= failed) failed = none;
      if (failed == none) step = std::min(longest_step, 2 * step);
      continue;
    }
    failed = limit.next_load_fraction = to;
    const double gap = to - limit.load_fraction;
    const bool is_finest = to < finest || gap <= finest * to;
    if (is_finest || gap <= resolution * to) {
      find_mode();
      // A mode of few nodes may be stiff until shortly before it is lost.
      if (is_finest || was_rejected || mode.curvature <= small * limit.rest_curvature)
        break;
    }
    step = gap / 2;
  }
  if (limit.load_fraction == 1) {
    limit.next_load_fraction = 1;
    return limit;
  }
  set_end(limit, potential, mode, was_rejected, passed);
  return limit;
}

}  // namespace springcheck::statics
