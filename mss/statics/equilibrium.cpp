#include "mss/statics/equilibrium.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <optional>
#include <random>
#include <tuple>

#include "meshing/cell_geometry.hpp"
#include "meshing/random_vector.hpp"
#include "meshing/stopwatch.hpp"
#include "mss/statics/minimum.hpp"
#include "mss/statics/static_solution.hpp"

namespace springcheck::mss {
namespace {

constexpr double smallest_load_step = 1. / 1024;
// Three searches to their end. The state sought may be far away, or none.
constexpr int most_lost_iterations = 450;

/// Whether unloading from the minimum found, where the landscape is linearised, leads
/// back to x, the path's last state. Measured on bodies of 3^3 to 6^3 cells: to first
/// order steps on the path lead back to within .01 to .22 of their length, jumps to .96
/// to 1; beside a bifurcation only a search tells.
bool leads_back(Landscape& landscape, const Positions& x, double reached,
                const Minimum& minimum, std::mt19937_64& random) {
  constexpr double clearly = 0.25, same = 1e-4;  // of the way between both states
  const double way = landscape.gradient(x, minimum.positions);
  Positions start = landscape.predicted(minimum.positions, reached);
  if (landscape.gradient(x, start) < clearly * way) return true;
  landscape.set_load(reached);
  const Minimum back = minimise(landscape, std::move(start), random);
  landscape.linearise(minimum.positions);
  return back.found && landscape.gradient(x, back.positions) < same * way;
}

}  // namespace

Solution find_equilibrium(const Mesh& mesh, const Scene& scene, const Network& network,
                          unsigned seed, LinearSolver linear_solver, double noise) {
  const Stopwatch stopwatch;
  Landscape landscape(mesh, scene, network, linear_solver);
  const double setup_wall_s = stopwatch.seconds();
  std::mt19937_64 random(seed);
  Positions x = mesh.nodes();
  double reached = 0;
  int steps = 0;
  SolveStatus status = SolveStatus::ok;
  std::string reason;
  std::optional<double> definite_up_to;

  // The last state before one that has a cell turned inside out, and its load.
  std::optional<std::pair<Positions, double>> last_unfolded;

  bool definite = true;
  landscape.linearise(x);
  // The chord of the whole path, or its length where that is longer: supports that turn.
  constexpr double little = 1. / 64;
  const Positions whole = landscape.predicted(x, 1);
  const double chord = landscape.gradient(x, whole);
  const double path = landscape.gradient(x, landscape.predicted(x, little)) / little;
  const double whole_gradient = path > 1.01 * chord ? path : chord;
  const double largest_step =
      whole_gradient > gradient_per_step
          ? std::max(gradient_per_step / whole_gradient, 2 * smallest_load_step)
          : 1;
  double step = largest_step;
  int lost_iterations = 0;
  bool left_path = false;  // by a step from the last state
  while (reached < 1) {
    // The last step may be a little longer, not a sliver.
    const double to = reached + 1.05 * step > 1 ? 1 : reached + step;
    if (!definite) landscape.linearise(x);
    landscape.set_load(reached);
    Positions start = reached == 0 && to == 1 ? whole : landscape.predicted(x, to);
    landscape.set_load(to);
    Minimum minimum = minimise(landscape, std::move(start), random);
    spdlog::debug("load {:.5f}: {}, residual {:.2e}", to,
                  minimum.found ? (minimum.definite ? "minimum" : "saddle") : "none",
                  minimum.residual);
    if (minimum.undecided) {
      status = SolveStatus::not_converged;
      reason = fmt::format(
          "conjugate gradients gave up at {:.2f} % of the load before they could tell "
          "whether the equilibrium found there is a minimum",
          100 * to);
      break;
    }
    const bool on_other_branch = minimum.found && minimum.crossed && definite &&
                                 minimum.definite &&
                                 !leads_back(landscape, x, reached, minimum, random);
    if (minimum.found && !on_other_branch) {
      if (!minimum.definite && !definite_up_to) definite_up_to = reached;
      if (!last_unfolded && has_inverted_cell(mesh.cells(), minimum.positions))
        last_unfolded = {std::move(x), reached};
      x = std::move(minimum.positions);
      definite = minimum.definite;
      reached = to;
      left_path = false;
      ++steps;
      step = std::min(largest_step, 2 * step);
      continue;
    }
    if (on_other_branch) spdlog::debug("load {:.5f}: on another branch", to);
    left_path = left_path || on_other_branch;
    step = (to - reached) / 2;
    if (!minimum.found && !minimum.ran_away) lost_iterations += minimum.iterations;
    if (step < smallest_load_step || lost_iterations >= most_lost_iterations) {
      const bool jumps = left_path && step < smallest_load_step;
      const bool path_ends = minimum.ran_away || jumps;
      status = path_ends ? SolveStatus::no_equilibrium : SolveStatus::not_converged;
      if (path_ends && !definite_up_to) definite_up_to = reached;
      reason = fmt::format(
          "{} beyond {:.2f} % of the load: steps down to {:.2g} % end {}",
          path_ends ? "no equilibrium found" : "not converged", 100 * reached, 200 * step,
          jumps ? "on another branch, from which unloading does not lead back"
          : minimum.ran_away
              ? "with a cell grown fourfold, the energy still falling"
              : fmt::format("with relative residual {:.1e}", minimum.residual));
      break;
    }
    landscape.linearise(x);
  }
  if (status == SolveStatus::ok && noise > 0) {
    const Eigen::VectorXd shake = random_vector(landscape.unknowns(), random);
    Minimum minimum = minimise(
        landscape, landscape.moved(x, shake, noise * landscape.cell_edge()), random);
    if (minimum.found && !minimum.undecided) {
      x = std::move(minimum.positions);
      definite = minimum.definite;
    } else {
      status =
          minimum.ran_away ? SolveStatus::no_equilibrium : SolveStatus::not_converged;
      reason = fmt::format(
          "a noise of {:g} cell edges leads away from the equilibrium, to none", noise);
    }
  }
  if (status == SolveStatus::ok && last_unfolded && !has_inverted_cell(mesh.cells(), x)) {
    status = SolveStatus::no_equilibrium;
    std::tie(x, reached) = std::move(*last_unfolded);
    reason = fmt::format(
        "no equilibrium of whole cells beyond {:.2f} % of the load: a cell is turned "
        "inside out there, and comes right again on another way",
        100 * reached);
    definite_up_to = std::min(reached, definite_up_to.value_or(reached));
  }
  if (status == SolveStatus::ok && !definite) {
    status = SolveStatus::indefinite;
    reason = fmt::format(
        "the tangent is not positive definite beyond {:.2f} % of the load, and no "
        "direction lowers the energy",
        100 * definite_up_to.value_or(reached));
  }

  Solution solution = static_solution(mesh, scene, network, x, reached);
  solution.status = status;
  solution.reason = reason;
  solution.steps = steps;
  solution.force_evaluations = landscape.evaluations();
  solution.definite_up_to = definite_up_to;
  solution.linear_iterations = landscape.linear_iterations();
  solution.factorisations = landscape.factorisations();
  solution.setup_wall_s = setup_wall_s;
  return solution;
}

}  // namespace springcheck::mss
