#include "statics/equilibrium.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <string_view>

#include "meshing/basics/random_vector.hpp"
#include "statics/minimum.hpp"
#include "statics/systems/nodal_vectors.hpp"

namespace springcheck::statics {
namespace {

constexpr double smallest_load_step = 1. / 1024;
constexpr double never = 2;  // a load beyond the full one
// Longer steps could take a turn of the supports for a smaller one.
constexpr double largest_gradient = 0.5;

/// Follows the minimum from rest.
class Follower {
 public:
  Follower(PotentialEnergy& potential, const Loading& loading, unsigned seed)
      : potential_(potential),
        loading_(loading),
        random_(seed),
        rest_(Eigen::VectorXd::Zero(loading.forces.size())),
        now_(potential.at(rest_)) {}

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

  [[nodiscard]] Equilibrium equilibrium() const {
    return {.status = status_,
            .reason = reason_,
            .displacements = now_.displacements,
            .reactions = potential_.reactions(now_),
            .strain_energy = now_.strain_energy,
            .load_fraction = reached_,
            .definite_up_to = definite_up_to_,
            .critical_wavelength = std::nullopt,
            .steps = steps_,
            .force_evaluations = potential_.evaluations(),
            .linear_iterations = potential_.linear_iterations(),
            .factorisations = potential_.factorisations(),
            .setup_wall_s = 0};
  }

 private:
  void follow() {
    potential_.linearise(rest_);
    const Eigen::VectorXd whole = potential_.predicted(rest_, 1);
    if (potential_.is_clamped()) definite_up_to_ = 0;
    const double gradient =
        potential_.body().is_linear() ? 0 : potential_.path_gradient(whole);
    const auto step_of = [&](double part) {
      return gradient > part ? std::max(part / gradient, 2 * smallest_load_step) : 1;
    };
    double step = step_of(first_gradient);
    // Loads that a step, and a search from any tangent, failed at, as long as they are
    // ahead:
    double failed = never, lost = never;
    Tangents tangents = Tangents::any;
    while (reached_ < 1) {
      // The last step may be a little longer, not a sliver.
      const double to = reached_ + 1.05 * step > 1 ? 1 : reached_ + step;
      if (!definite_ || potential_.is_clamped()) potential_.linearise(now_.displacements);
      potential_.set_load(reached_);
      Eigen::VectorXd start =
          reached_ == 0 && to == 1 ? whole : potential_.predicted(now_.displacements, to);
      potential_.set_load(to);
      left_to_ = {};
      was_unloaded_ = false;
      Minimum minimum = minimise(potential_, std::move(start), random_, tangents);
      spdlog::debug("load {:.5f}: {}, residual {:.2e}", to,
                    minimum.found ? (minimum.definite ? "minimum" : "saddle") : "none",
                    minimum.residual);
      if (minimum.undecided) return leave_undecided(to);
      if (minimum.found && is_on_path(minimum, to)) {
        accept(std::move(minimum), to, to == failed);
        if (failed == never) step = std::min(step_of(largest_gradient), 2 * step);
        // What a long step failed at is tried again by a shorter one.
        if (to >= failed) failed = never;
        if (to >= lost) lost = never;
        tangents = lost == never || !definite_ ? Tangents::any : Tangents::definite;
        continue;
      }
      const double gap = to - reached_;
      const bool is_smallest = gap < 2 * smallest_load_step;
      if (is_smallest && tangents == Tangents::any) return give_up(minimum, gap);
      failed = to;
      if (tangents == Tangents::any) lost = to;
      // How far stable states go is found first, which costs little; then how the path
      // goes on.
      tangents = is_smallest || !definite_ ? Tangents::any : Tangents::definite;
      step = is_smallest ? gap : gap / 2;
      potential_.linearise(now_.displacements);
    }
  }

  /// Whether the path leads to the minimum found; where it does not, left_to_ says where
  /// it is.
  bool is_on_path(const Minimum& minimum, double to) {
    std::string_view astray;
    if (!loading_.follows_supports(minimum.state.displacements, to))
      astray = "in a body that is not turned as its plates are";
    else if (is_doubtful(minimum) && definite_ && minimum.definite &&
             !leads_back(minimum, to))
      astray = "on another branch, from which unloading does not lead back";
    if (astray.empty()) return true;
    spdlog::debug("load {:.5f}: ends {}", to, astray);
    left_to_ = astray;
    return false;
  }

  /// Whether a search may have come to another branch: it met an indefinite tangent, or
  /// went far.
  [[nodiscard]] bool is_doubtful(const Minimum& minimum) const {
    constexpr double far = 1.1 * first_gradient;
    const ElasticBody& body = potential_.body();
    return minimum.crossed ||
           (!body.is_linear() &&
            body.mean_gradient(minimum.state.displacements - now_.displacements) > far);
  }

  /// Whether unloading from the minimum found, where the energy is linearised, leads
  /// back to the path's last state. Measured on bodies of 3^3 to 6^3 cells: to first
  /// order steps on the path lead back to within .01 to .22 of their length, jumps to .96
  /// to 1; beside a bifurcation only a search tells.
  bool leads_back(const Minimum& minimum, double to) {
    constexpr double clearly = 0.25, same = 1e-4;  // of the way between both states
    const Eigen::VectorXd& there = minimum.state.displacements;
    const auto from_last = [&](const Eigen::VectorXd& state) {
      return potential_.body().mean_gradient(state - now_.displacements);
    };
    const double way = from_last(there);
    if (from_last(potential_.predicted(there, reached_)) < clearly * way) return true;
    was_unloaded_ = true;
    const auto back = unloaded(there, to);
    potential_.linearise(there);
    return back && from_last(*back) < same * way;
  }

  /// The state that unloading from there to the last state's load leads to; in parts
  /// where it finds none at once.
  std::optional<Eigen::VectorXd> unloaded(const Eigen::VectorXd& there, double from) {
    for (const int parts : {1, 4, 16}) {
      Eigen::VectorXd u = there;
      bool found = true;
      for (int part = 1; part <= parts && found; ++part) {
        const auto load = [&](int p) { return from + p * (reached_ - from) / parts; };
        potential_.set_load(load(part - 1));
        potential_.linearise(u);
        Eigen::VectorXd start = potential_.predicted(u, load(part));
        potential_.set_load(load(part));
        Minimum back = minimise(potential_, std::move(start), random_,
                                parts == 1 ? Tangents::any : Tangents::definite);
        found = back.found;
        u = std::move(back.state.displacements);
      }
      if (found) return u;
    }
    return std::nullopt;
  }

  /// leaves_stable: definite tangents do not lead there.
  void accept(Minimum minimum, double to, bool leaves_stable) {
    const bool branches = minimum.crossed && leaves_stable;
    if ((!minimum.definite || branches) && !definite_up_to_) definite_up_to_ = reached_;
    if ((branches || (minimum.crossed && was_unloaded_)) && reason_.empty())
      reason_ = fmt::format(
          "the path {} between {:.2f} % and {:.2f} % of the load, where a search met "
          "tangents that are not positive definite",
          branches ? "branches" : "may branch", 100 * reached_, 100 * to);
    now_ = std::move(minimum.state);
    definite_ = minimum.definite;
    reached_ = to;
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
    const bool collapses = last.inverted && last.crossed;
    const bool path_ends = last.crossed || last.ran_away || !left_to_.empty();
    status_ = path_ends ? SolveStatus::no_equilibrium : SolveStatus::not_converged;
    if (path_ends && !definite_up_to_) definite_up_to_ = reached_;
    reason_ = fmt::format(
        "{} beyond {:.2f} % of the load{}: steps down to {:.2g} % end {}",
        path_ends ? "no equilibrium found" : "not converged", 100 * reached_,
        last.crossed ? ", where stability is lost" : "", 100 * step,
        !left_to_.empty() ? std::string(left_to_)
        : last.ran_away   ? "with a cell grown fourfold, the energy still falling"
        : collapses       ? "with a cell turned inside out, the energy falling"
        : last.inverted   ? "with a cell turned inside out"
                          : fmt::format("with relative residual {:.1e}", last.residual));
  }

  void shake(double noise) {
    potential_.set_load(reached_);
    const Eigen::VectorXd shake = noise * potential_.body().cell_edge() *
                                  random_vector(potential_.unknowns().count(), random_);
    Minimum minimum =
        minimise(potential_, potential_.moved(now_.displacements, shake), random_);
    if (minimum.found && !minimum.undecided &&
        loading_.follows_supports(minimum.state.displacements, reached_)) {
      now_ = std::move(minimum.state);
      definite_ = minimum.definite;
      return;
    }
    status_ = minimum.ran_away ? SolveStatus::no_equilibrium : SolveStatus::not_converged;
    reason_ = fmt::format(
        "a noise of {:g} cell edges leads away from the equilibrium, to none", noise);
  }

  PotentialEnergy& potential_;
  const Loading& loading_;
  std::mt19937_64 random_;
  Eigen::VectorXd rest_;
  PotentialEnergy::State now_;  // at reached_, under its load
  double reached_ = 0;
  bool definite_ = true;
  SolveStatus status_ = SolveStatus::ok;
  std::string reason_;
  std::optional<double> definite_up_to_;
  int steps_ = 0;
  std::string_view left_to_;   // by the last search, if that was astray
  bool was_unloaded_ = false;  // its end, to tell that
};

}  // namespace

void tell_truncated(Equilibrium& equilibrium, int truncated) {
  if (equilibrium.reason.empty() || truncated == 0) return;
  equilibrium.reason += fmt::format(
      "; conjugate gradients gave up on {} of the linear systems before they were as "
      "accurate as asked",
      truncated);
}

Solution solution_of(const Equilibrium& equilibrium) {
  return {.status = equilibrium.status,
          .reason = equilibrium.reason,
          .displacements = by_node(equilibrium.displacements),
          .reactions = by_node(equilibrium.reactions),
          .lever_arms = LeverArms::deformed,
          .strain_energy = equilibrium.strain_energy,
          .load_fraction = equilibrium.load_fraction,
          .steps = equilibrium.steps,
          .force_evaluations = equilibrium.force_evaluations,
          .definite_up_to = equilibrium.definite_up_to,
          .critical_wavelength = equilibrium.critical_wavelength,
          .linear_iterations = equilibrium.linear_iterations,
          .factorisations = equilibrium.factorisations,
          .setup_wall_s = equilibrium.setup_wall_s};
}

Equilibrium find_equilibrium(ElasticBody& body, const Loading& loading,
                             const Search& search, const Stopwatch& setup) {
  PotentialEnergy potential(body, loading, search.linear_solver);
  const double setup_wall_s = setup.seconds();
  Follower path(potential, loading, search.seed);
  path.run(search.noise);
  Equilibrium equilibrium = path.equilibrium();
  tell_truncated(equilibrium, potential.truncated());
  equilibrium.setup_wall_s = setup_wall_s;
  return equilibrium;
}

}  // namespace springcheck::statics
