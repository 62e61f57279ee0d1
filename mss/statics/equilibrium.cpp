#include "mss/statics/equilibrium.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <string_view>

#include "meshing/random_vector.hpp"
#include "meshing/stopwatch.hpp"
#include "meshing/turn.hpp"
#include "mss/statics/minimum.hpp"
#include "mss/statics/static_solution.hpp"

namespace springcheck::mss {
namespace {

constexpr double smallest_load_step = 1. / 1024;
// Three searches to their end. The state sought may be far away, or none.
constexpr int most_lost_iterations = 450;

/// Follows the minimum from rest.
class Follower {
 public:
  Follower(const Mesh& mesh, const Scene& scene, Landscape& landscape, unsigned seed)
      : mesh_(mesh), scene_(scene), landscape_(landscape), random_(seed) {}

  void run(double noise) {
    follow();
    if (status_ == SolveStatus::ok && noise > 0) shake(noise);
    if (status_ != SolveStatus::ok || definite_) return;
    status_ = SolveStatus::indefinite;
    reason_ = fmt::format(
        "the tangent is not positive definite beyond {:.2f} % of the load, and no "
        "direction lowers the energy",
        100 * definite_up_to_.value_or(reached_));
  }

  [[nodiscard]] Solution solution(const Network& network) const {
    Solution solution = static_solution(mesh_, scene_, network, x_, reached_);
    solution.status = status_;
    solution.reason = reason_;
    solution.steps = steps_;
    solution.definite_up_to = definite_up_to_;
    return solution;
  }

 private:
  void follow() {
    landscape_.linearise(x_);
    const Positions whole = landscape_.predicted(x_, 1);
    const double gradient = landscape_.path_gradient(x_, whole);
    const double largest_step =
        gradient > gradient_per_step
            ? std::max(gradient_per_step / gradient, 2 * smallest_load_step)
            : 1;

    double step = largest_step;
    while (reached_ < 1) {
      // The last step may be a little longer, not a sliver.
      const double to = reached_ + 1.05 * step > 1 ? 1 : reached_ + step;
      if (!definite_) landscape_.linearise(x_);
      landscape_.set_load(reached_);
      Positions start = reached_ == 0 && to == 1 ? whole : landscape_.predicted(x_, to);
      landscape_.set_load(to);
      Minimum minimum = minimise(landscape_, std::move(start), random_);
      spdlog::debug("load {:.5f}: {}, residual {:.2e}", to,
                    minimum.found ? (minimum.definite ? "minimum" : "saddle") : "none",
                    minimum.residual);
      if (minimum.undecided) return leave_undecided(to);
      if (minimum.found && is_on_path(minimum, to)) {
        accept(std::move(minimum), to);
        step = std::min(largest_step, 2 * step);
        continue;
      }
      step = (to - reached_) / 2;
      if (!minimum.found && !minimum.ran_away) lost_iterations_ += minimum.iterations;
      if (step < smallest_load_step || lost_iterations_ >= most_lost_iterations)
        return give_up(minimum, step);
      landscape_.linearise(x_);
    }
  }

  /// Whether the path leads to the minimum found; where it does not, left_to_ says where
  /// it is.
  bool is_on_path(const Minimum& minimum, double to) {
    std::string_view astray;
    if (!shows_imposed_turn(mesh_, scene_, minimum.positions, to))
      astray = "in a body that is not turned as its plates are";
    else if (minimum.crossed && definite_ && minimum.definite && !leads_back(minimum))
      astray = "on another branch, from which unloading does not lead back";
    if (astray.empty()) return true;
    spdlog::debug("load {:.5f}: ends {}", to, astray);
    left_to_ = astray;
    return false;
  }

  /// Whether unloading from the minimum found, where the landscape is linearised, leads
  /// back to the path's last state. Measured on bodies of 3^3 to 6^3 cells: to first
  /// order steps on the path lead back to within .01 to .22 of their length, jumps to .96
  /// to 1; beside a bifurcation only a search tells.
  bool leads_back(const Minimum& minimum) {
    constexpr double clearly = 0.25, same = 1e-4;  // of the way between both states
    const double way = landscape_.gradient(x_, minimum.positions);
    Positions start = landscape_.predicted(minimum.positions, reached_);
    if (landscape_.gradient(x_, start) < clearly * way) return true;
    landscape_.set_load(reached_);
    const Minimum back = minimise(landscape_, std::move(start), random_);
    landscape_.linearise(minimum.positions);
    return back.found && landscape_.gradient(x_, back.positions) < same * way;
  }

  void accept(Minimum minimum, double to) {
    if (!minimum.definite && !definite_up_to_) definite_up_to_ = reached_;
    x_ = std::move(minimum.positions);
    definite_ = minimum.definite;
    reached_ = to;
    left_to_ = {};
    ++steps_;
  }

  void leave_undecided(double to) {
    status_ = SolveStatus::not_converged;
    reason_ = fmt::format(
        "conjugate gradients gave up at {:.2f} % of the load before they could tell "
        "whether the equilibrium found there is a minimum",
        100 * to);
  }

  void give_up(const Minimum& last, double step) {
    const bool jumps = !left_to_.empty() && step < smallest_load_step;
    const bool path_ends = last.ran_away || jumps;
    status_ = path_ends ? SolveStatus::no_equilibrium : SolveStatus::not_converged;
    if (path_ends && !definite_up_to_) definite_up_to_ = reached_;
    reason_ = fmt::format(
        "{} beyond {:.2f} % of the load: steps down to {:.2g} % end {}",
        path_ends ? "no equilibrium found" : "not converged", 100 * reached_, 200 * step,
        jumps           ? std::string(left_to_)
        : last.ran_away ? "with a cell grown fourfold, the energy still falling"
                        : fmt::format("with relative residual {:.1e}", last.residual));
  }

  void shake(double noise) {
    const Eigen::VectorXd shake = random_vector(landscape_.unknowns(), random_);
    Minimum minimum = minimise(
        landscape_, landscape_.moved(x_, shake, noise * landscape_.cell_edge()), random_);
    if (minimum.found && !minimum.undecided) {
      x_ = std::move(minimum.positions);
      definite_ = minimum.definite;
      return;
    }
    status_ = minimum.ran_away ? SolveStatus::no_equilibrium : SolveStatus::not_converged;
    reason_ = fmt::format(
        "a noise of {:g} cell edges leads away from the equilibrium, to none", noise);
  }

  const Mesh& mesh_;
  const Scene& scene_;
  Landscape& landscape_;
  std::mt19937_64 random_;
  Positions x_ = mesh_.nodes();
  double reached_ = 0;
  bool definite_ = true;
  SolveStatus status_ = SolveStatus::ok;
  std::string reason_;
  std::optional<double> definite_up_to_;
  int steps_ = 0, lost_iterations_ = 0;
  std::string_view left_to_;  // by steps from the last state
};

}  // namespace

Solution find_equilibrium(const Mesh& mesh, const Scene& scene, const Network& network,
                          unsigned seed, statics::LinearSolver linear_solver,
                          double noise) {
  const Stopwatch stopwatch;
  Landscape landscape(mesh, scene, network, linear_solver);
  const double setup_wall_s = stopwatch.seconds();
  Follower path(mesh, scene, landscape, seed);
  path.run(noise);
  Solution solution = path.solution(network);
  solution.force_evaluations = landscape.evaluations();
  solution.linear_iterations = landscape.linear_iterations();
  solution.factorisations = landscape.factorisations();
  if (!solution.reason.empty() && landscape.truncated() > 0)
    solution.reason += fmt::format(
        "; conjugate gradients gave up on {} of the linear systems before they were as "
        "accurate as asked",
        landscape.truncated());
  solution.setup_wall_s = setup_wall_s;
  return solution;
}

}  // namespace springcheck::mss
