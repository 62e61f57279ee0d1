#include "fem_reference/statics/equilibrium.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "fem_reference/statics/limit_point.hpp"
#include "fem_reference/statics/newton.hpp"

namespace springcheck::fem_reference {
namespace {

constexpr double smallest_load_step = 1. / 1024;
constexpr double first_indefinite_load_step = 1. / 64;

/// Root mean square of the displacement gradient in the first load step: 20 % compression
/// begins with about a quarter of the load, 5 % is one step.
constexpr double first_gradient = 0.06;
constexpr double largest_gradient = 0.5;  // in any step

/// Where the path ran with an indefinite tangent.
struct LossOfDefiniteness {
  double last_definite = 1;
  double regained = 1;
  [[nodiscard]] bool happened() const { return last_definite < 1; }
};

/// A converged state on the path, its factor in the body.
struct Path {
  Eigen::VectorXd displacements;
  Elasticity::Internal internal;
  double load_fraction = 0;
  bool definite = true;
};

class Follower {
 public:
  Follower(Elasticity& body, const LoadProgram& program)
      : body_(body), program_(program) {}

  Equilibrium run() {
    rest();
    if (!body_.is_linear()) measure_path();
    double step = first_step();
    bool failed_before = false;
    while (path_.load_fraction < 1) {
      const double to = path_.load_fraction + step > 1 - smallest_load_step
                            ? 1
                            : path_.load_fraction + step;
      NewtonResult result = attempt(to);
      evaluations_ += result.force_evaluations;
      spdlog::debug("load {:.5f}: {}, relative residual {:.2e}", to,
                    words(result.outcome), result.residual);
      if (result.outcome == NewtonOutcome::converged && !is_on_path(result, to))
        result.outcome = NewtonOutcome::astray;
      if (result.outcome == NewtonOutcome::converged) {
        accept(std::move(result), to);
        if (!failed_before) step = std::min(2 * step, longest_step());
        failed_before = false;
        continue;
      }
      failed_before = true;
      step = std::min(step, to - path_.load_fraction) / 2;
      if (step < smallest_load_step) {
        if (result.outcome != NewtonOutcome::indefinite) return give_up(result, to);
        tangents_ = Tangents::any;
        step = first_indefinite_load_step;
      }
      return_to_path();
    }
    return finish(path_.definite ? SolveStatus::ok : SolveStatus::indefinite,
                  history(path_.definite));
  }

 private:
  void rest() {
    path_.displacements = Eigen::VectorXd::Zero(program_.forces.size());
    path_.internal = body_.internal(path_.displacements);
    ++evaluations_;
    path_.definite = body_.linearise(path_.displacements);
    if (path_.definite) return;
    loss_.last_definite = 0;
    body_.accept_indefinite();
  }

  void return_to_path() {
    body_.linearise(path_.displacements);
    if (!path_.definite) body_.accept_indefinite();
  }

  /// The state that the tangent predicts, or the old one on moved supports.
  Eigen::VectorXd predicted(double to) {
    return predicted(path_.displacements, path_.internal.forces, to);
  }
  Eigen::VectorXd predicted(const Eigen::VectorXd& from, const Eigen::VectorXd& forces,
                            double to) {
    const Eigen::VectorXd increment = program_.displacements(to) - from;
    const Eigen::VectorXd moved = increment - body_.free_part(increment);
    return from + body_.step(to * program_.forces - forces, increment).value_or(moved);
  }

  /// Where Hooke's law takes the supports is one place.
  bool is_on_path(const NewtonResult& result, double to) {
    if (body_.is_linear()) return true;
    shows_other_turn_ = !program_.follows_supports(result.displacements, to);
    return !shows_other_turn_ && leads_back(result, to);
  }

  /// Whether what was found with indefinite tangents, at which the body is linearised, is
  /// on the path: to first order it leads back to the last state. Other branches, such as
  /// a smaller turn of the supports, are not met with definite ones.
  bool leads_back(const NewtonResult& result, double to) {
    constexpr double clearly = 0.75;  // of the way; next to a limit point a half is usual
    if (tangents_ == Tangents::definite) return true;
    const Eigen::VectorXd back =
        predicted(result.displacements, result.internal.forces, path_.load_fraction);
    const auto distance = [&](const Eigen::VectorXd& state) {
      return (state - path_.displacements).norm();
    };
    spdlog::debug("load {:.5f}: leads back to {:.2g} of the way", to,
                  distance(back) / distance(result.displacements));
    return distance(back) < clearly * distance(result.displacements);
  }

  /// Sets the length of the path: its chord, or longer where the supports turn.
  void measure_path() {
    constexpr double little = 1. / 64;
    const double chord = body_.internal(predicted(1)).mean_gradient;
    const double path = body_.internal(predicted(little)).mean_gradient / little;
    evaluations_ += 2;
    gradient_ = path > 1.01 * chord ? path : chord;
  }

  [[nodiscard]] double first_step() const {
    return gradient_ > first_gradient
               ? std::max(first_gradient / gradient_, smallest_load_step)
               : 1;
  }

  /// Longer steps could take a turn of the supports for a smaller one.
  [[nodiscard]] double longest_step() const {
    return gradient_ > largest_gradient ? largest_gradient / gradient_ : 1;
  }

  /// |du/ds| of the free nodes from the path to a predicted state [m].
  [[nodiscard]] double rate(const Eigen::VectorXd& state, double to) const {
    return body_.free_part(state - path_.displacements).norm() /
           std::abs(to - path_.load_fraction);
  }

  NewtonResult attempt(double to) {
    Eigen::VectorXd start = predicted(to);
    if (!rates_.empty() && rates_.back().load_fraction == path_.load_fraction)
      rates_.pop_back();
    rates_.push_back(
        {.load_fraction = path_.load_fraction, .displacement = rate(start, to)});
    return newton(body_, std::move(start), to * program_.forces, tangents_);
  }

  void accept(NewtonResult result, double to) {
    if (path_.definite && !result.definite && !loss_.happened())
      loss_.last_definite = path_.load_fraction;
    if (!path_.definite && result.definite) loss_.regained = to;
    if (result.definite) tangents_ = Tangents::definite;
    path_ = {.displacements = std::move(result.displacements),
             .internal = std::move(result.internal),
             .load_fraction = to,
             .definite = result.definite};
    ++steps_;
  }

  [[nodiscard]] std::string history(bool definite) const {
    if (!loss_.happened()) return "";
    if (definite)
      return fmt::format(
          "the tangent was not positive definite between {:.2f} % and "
          "{:.2f} % of the load",
          100 * loss_.last_definite, 100 * loss_.regained);
    return fmt::format("the tangent lost positive definiteness at {:.2f} % of the load{}",
                       100 * loss_.last_definite,
                       body_.negative_eigenvalues()
                           ? fmt::format(" (negative eigenvalues now: {})",
                                         *body_.negative_eigenvalues())
                           : "");
  }

  /// The last state's rate is taken backwards here: supports that jump make Newton's
  /// method fail too, and the way beyond them is as steep as before a limit point.
  bool ends_in_limit_point(double failed) {
    if (rates_.size() < 2) return false;
    return_to_path();
    const double before = rates_[rates_.size() - 2].load_fraction;
    rates_.back().displacement = rate(predicted(before), before);
    return limit_point_ahead(rates_, failed);
  }

  Equilibrium give_up(const NewtonResult& result, double to) {
    // An inverted cell, or a residual that rounding keeps from the tolerance, is no sign
    // that the path ends.
    constexpr double rounding = 1e-8;
    const bool limit_point =
        tangents_ == Tangents::any && result.outcome != NewtonOutcome::inverted &&
        (result.residual > rounding || result.outcome == NewtonOutcome::astray) &&
        ends_in_limit_point(to);
    if (limit_point)
      loss_.last_definite = std::min(loss_.last_definite, path_.load_fraction);
    const bool ends =
        limit_point || (result.outcome == NewtonOutcome::astray && shows_other_turn_);
    std::string reason = fmt::format(
        "{} at {:.2f} % of the load: from there to {:.2f} % Newton's method {} (relative "
        "residual {:.1e}, smallest det F {:.3g})",
        limit_point ? "limit point"
        : ends      ? "the path ends"
                    : "gave up",
        100 * path_.load_fraction, 100 * to, words(result.outcome), result.residual,
        result.internal.smallest_jacobian);
    if (limit_point)
      reason += fmt::format("; the tangent loses positive definiteness at {:.2f} %",
                            100 * std::min(loss_.last_definite, path_.load_fraction));
    return finish(ends ? SolveStatus::no_equilibrium : SolveStatus::not_converged,
                  std::move(reason));
  }

  [[nodiscard]] std::string_view words(NewtonOutcome outcome) const {
    switch (outcome) {
      case NewtonOutcome::converged:
        return "converged";
      case NewtonOutcome::indefinite:
        return "met an indefinite tangent";
      case NewtonOutcome::inverted:
        return "turned a cell inside out";
      case NewtonOutcome::astray:
        return shows_other_turn_ ? "found a body that is not turned as its plates are"
                                 : "found another branch";
      case NewtonOutcome::stalled:
        break;
    }
    return "did not converge";
  }

  Equilibrium finish(SolveStatus status, std::string reason) {
    const Eigen::VectorXd difference =
        path_.internal.forces - path_.load_fraction * program_.forces;
    return {.status = status,
            .reason = std::move(reason),
            .displacements = path_.displacements,
            .reactions = difference - body_.free_part(difference),
            .energy = path_.internal.energy,
            .load_fraction = path_.load_fraction,
            .definite_up_to =
                loss_.happened()
                    ? std::optional(std::min(loss_.last_definite, path_.load_fraction))
                    : std::nullopt,
            .steps = steps_,
            .force_evaluations = evaluations_};
  }

  Elasticity& body_;
  const LoadProgram& program_;
  Path path_;
  Tangents tangents_ = Tangents::definite;
  LossOfDefiniteness loss_;
  std::vector<Rate> rates_;
  double gradient_ = 0;            // of the whole path, see first_gradient
  bool shows_other_turn_ = false;  // what was found last
  int steps_ = 0;
  int evaluations_ = 0;
};

}  // namespace

Equilibrium find_equilibrium(Elasticity& body, const LoadProgram& program) {
  return Follower(body, program).run();
}

}  // namespace springcheck::fem_reference
