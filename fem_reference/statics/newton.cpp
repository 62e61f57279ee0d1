#include "fem_reference/statics/newton.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

namespace springcheck::fem_reference {
namespace {

constexpr double relative_residual = 1e-10;
constexpr int most_iterations = 15;
constexpr double smallest_step = 1. / 16;
constexpr double sufficient_decrease = 1e-4;

/// An iterate with all that is judged about it.
struct Iterate {
  Eigen::VectorXd displacements;
  Elasticity::Internal internal{};
  Eigen::VectorXd unbalanced{};  // load minus internal forces on free nodes [N]
  double total_energy;           // W - load.u [J]
  double scale;                  // larger of reactions and load [N]
  double relative;               // residual over scale

  [[nodiscard]] bool usable(bool is_linear) const {
    return std::isfinite(total_energy) && std::isfinite(relative) &&
           (is_linear || internal.smallest_jacobian > 0);
  }
};

Iterate evaluate(const Elasticity& body, Eigen::VectorXd displacements,
                 const Eigen::VectorXd& load) {
  Iterate now{.displacements = std::move(displacements),
              .total_energy = 0,
              .scale = 0,
              .relative = 0};
  now.internal = body.internal(now.displacements);
  const Eigen::VectorXd difference = load - now.internal.forces;
  now.unbalanced = body.free_part(difference);
  now.total_energy = now.internal.energy - load.dot(now.displacements);
  now.scale = std::max((difference - now.unbalanced).norm(), load.norm());
  const double residual = now.unbalanced.norm();
  now.relative = residual == 0 ? 0 : residual / now.scale;
  return now;
}

}  // namespace

NewtonResult newton(Elasticity& body, Eigen::VectorXd start, const Eigen::VectorXd& load,
                    Tangents tangents) {
  const Eigen::VectorXd no_increment = Eigen::VectorXd::Zero(start.size());
  Iterate now = evaluate(body, std::move(start), load);
  int evaluations = 1;
  bool definite = false;
  const auto finish = [&](NewtonOutcome outcome) {
    return NewtonResult{.outcome = outcome,
                        .internal = std::move(now.internal),
                        .displacements = std::move(now.displacements),
                        .residual = now.relative,
                        .definite = definite,
                        .force_evaluations = evaluations};
  };

  for (int iteration = 0;; ++iteration) {
    if (!now.usable(body.is_linear()))
      return finish(now.internal.smallest_jacobian <= 0 ? NewtonOutcome::inverted
                                                        : NewtonOutcome::stalled);
    definite = body.linearise(now.displacements);
    const bool converged = now.relative <= relative_residual ||
                           now.unbalanced.norm() <= body.round_off(now.displacements);
    if (converged) definite = body.is_definite();
    std::optional<Eigen::VectorXd> step;
    if (definite && !converged) {
      step = body.step(now.unbalanced, no_increment);
      if (!step) {
        definite = body.is_definite();
        if (definite) return finish(NewtonOutcome::stalled);
      }
    }
    spdlog::debug("  newton {}: relative residual {:.2e}{}", iteration, now.relative,
                  definite ? "" : ", tangent indefinite");
    if (!definite) {
      if (tangents == Tangents::definite) return finish(NewtonOutcome::indefinite);
      if (!body.accept_indefinite()) return finish(NewtonOutcome::stalled);
    }
    if (converged) return finish(NewtonOutcome::converged);
    if (iteration == most_iterations) return finish(NewtonOutcome::stalled);
    if (!definite) step = body.step(now.unbalanced, no_increment);
    if (!step) return finish(NewtonOutcome::stalled);

    const double slope = -now.unbalanced.dot(*step);
    const auto better = [&](const Iterate& trial, double factor) {
      if (!trial.usable(body.is_linear())) return false;
      if (trial.unbalanced.norm() < now.unbalanced.norm()) return true;
      return definite && trial.total_energy <=
                             now.total_energy + sufficient_decrease * factor * slope;
    };
    double factor = 1;
    Iterate trial = evaluate(body, now.displacements + *step, load);
    for (++evaluations; !better(trial, factor); ++evaluations) {
      factor /= 2;
      if (factor < smallest_step) return finish(NewtonOutcome::stalled);
      trial = evaluate(body, now.displacements + factor * *step, load);
    }
    now = std::move(trial);
  }
}

}  // namespace springcheck::fem_reference
