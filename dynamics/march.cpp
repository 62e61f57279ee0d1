#include "dynamics/march.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace springcheck::dynamics {
namespace {

constexpr double safety = 0.9;  // of the stability limit, for an open step
constexpr int steps_between_checks = 100;
constexpr int steps_between_limits = 1000;
constexpr double worth_a_change = 0.02;  // of an open step
constexpr double lost = 100;             // body sizes
constexpr double seconds_between_progress = 0.5;

double body_size(const std::vector<Vector3>& nodes) {
  Vector3 low = nodes.front(), high = low;
  for (const Vector3& x : nodes) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).norm();
}

/// The longest of the vectors; infinite if any of them is not finite.
double longest(const std::vector<Vector3>& vectors) {
  double square = 0;
  for (const Vector3& v : vectors) {
    if (!v.allFinite()) return std::numeric_limits<double>::infinity();
    square = std::max(square, v.squaredNorm());
  }
  return std::sqrt(square);
}

std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// A whole number of steps of about `wanted` in `time`.
int step_count(double time, double wanted) {
  return static_cast<int>(std::max(1., std::ceil(time / wanted - 1e-9)));
}

/// Why the march does not begin, if it does not.
std::string reason_to_refuse(const MarchedBody& body, const Protocol& protocol,
                             double limit, bool is_anything_free) {
  const double wanted = protocol.time_step.value_or(safety * limit);
  if (protocol.time_step && wanted > limit && !protocol.force_time_step)
    return fmt::format(
        "dt = {:.4g} s is above the stability limit {:.4g} s ({}); force-dt runs it all "
        "the same",
        wanted, limit, body.step_setters);
  if (!protocol.time_step && limit == 0)
    return "explicit Euler is stable with no step where a motion is not damped; dashpots "
           "(--damping) damp what stretches springs, and --dt with --force-dt runs it "
           "all "
           "the same";
  if (std::isinf(wanted) && is_anything_free)
    return protocol.integrator == Integrator::implicit_euler
               ? "implicit Euler is stable with every step: dt = auto has none to choose"
               : "dt = auto has no swing to go by: no motion about the rest state has a "
                 "positive stiffness";
  if (!(protocol.duration / wanted < std::numeric_limits<int>::max()))
    return fmt::format("dt = {:.4g} s needs {:.3g} steps, more than can be counted",
                       wanted, protocol.duration / wanted);
  return {};
}

class March {
 public:
  March(const MarchedBody& body, Motion& motion, const Protocol& protocol,
        const Observers& observers, double limit)
      : body_(body),
        motion_(motion),
        protocol_(protocol),
        observers_(observers),
        prescribed_(prescribed_components(body.mesh, body.scene)),
        is_free_(free_components(body.mesh, prescribed_)),
        far_(lost * body_size(body.mesh.nodes())) {
    if (observers.from) {
      now_ = *observers.from;
      motion_.restore(now_.state);
      return;
    }
    now_.limit = limit;
    now_.steps_left =
        step_count(protocol.duration, protocol.time_step.value_or(safety * limit));
    now_.dt = protocol.duration / now_.steps_left;
  }

  Solution run() {
    Solution solution{.status = SolveStatus::ok,
                      .reason = {},
                      .displacements = {},
                      .reactions = {},
                      .lever_arms = LeverArms::deformed,
                      .strain_energy = 0,
                      .load_fraction = 0,
                      .steps = 0,
                      .force_evaluations = 0};
    auto last_progress = std::chrono::steady_clock::now(),
         last_checkpoint = last_progress;
    std::vector<AffineDisplacement> motions = support_motions(body_.scene, fraction());
    while (now_.steps_left > 0) {
      std::vector<AffineDisplacement> before = std::move(motions);
      const bool halved = protocol_.integrator == Integrator::verlet;
      const double kick = halved ? (now_.last_dt + now_.dt) / 2 : now_.dt;
      --now_.steps_left;
      // The last step ends where the protocol does, to the bit.
      now_.time = now_.steps_left == 0 ? protocol_.duration : now_.time + now_.dt;
      motions = support_motions(body_.scene, fraction());
      motion_.advance({.dt = now_.dt,
                       .kick = kick,
                       .load_fraction = fraction(),
                       .motions_before = std::move(before),
                       .motions = motions});
      now_.last_dt = now_.dt;
      ++now_.step;
      const bool at_end = now_.steps_left == 0;
      if ((now_.step % steps_between_checks == 0 || at_end) &&
          !(longest(motion_.state().displacements) < far_)) {
        solution.status = SolveStatus::diverged;
        solution.reason = fmt::format(
            "positions left all bounds by step {} of {} (t = {:.4g} s, dt = {:.4g} s, "
            "stability limit {:.4g} s)",
            now_.step, now_.step + now_.steps_left, now_.time, now_.dt, now_.limit);
        break;
      }
      if (now_.step % steps_between_limits == 0 && !at_end && !protocol_.time_step)
        follow_limit();
      if (observers_.sample && is_time_of_sample()) observers_.sample(moment());
      const auto clock = std::chrono::steady_clock::now();
      const auto is_due = [&](auto last, double seconds) {
        return std::chrono::duration<double>(clock - last).count() >= seconds;
      };
      if (observers_.progress && is_due(last_progress, seconds_between_progress)) {
        observers_.progress(now_);
        last_progress = clock;
      }
      if (observers_.checkpoint && !at_end &&
          is_due(last_checkpoint, observers_.seconds_between_checkpoints)) {
        now_.state = motion_.state();
        observers_.checkpoint(now_);
        last_checkpoint = clock;
      }
    }
    Moment end = moment();
    solution.steps = now_.step;
    solution.force_evaluations = now_.step + 1;
    solution.dt = now_.dt;
    solution.dt_limit = if_finite(now_.limit);
    solution.load_fraction = end.load_fraction;
    solution.strain_energy = end.strain_energy;
    solution.kinetic_energy = end.kinetic_energy;
    solution.displacements = std::move(end.displacements);
    solution.reactions = std::move(end.reactions);
    return solution;
  }

 private:
  [[nodiscard]] double fraction() const { return now_.time / protocol_.duration; }

  /// Whether a multiple of the duration over the samples lies in the step just made.
  [[nodiscard]] bool is_time_of_sample() const {
    const auto passed = [&](double time) {
      return std::floor(time / protocol_.duration * observers_.samples + 1e-9);
    };
    return now_.steps_left == 0 || passed(now_.time) > passed(now_.time - now_.last_dt);
  }

  void follow_limit() {
    const State here = motion_.state();
    const double limit = body_.stable_step(here);
    now_.limit = limit;
    const double left = protocol_.duration - now_.time;
    // Where no countable number of steps is stable, going on shows what becomes of it.
    if (!std::isfinite(limit) ||
        !(left / (safety * limit) < std::numeric_limits<int>::max() - now_.step))
      return;
    const int steps = step_count(left, safety * limit);
    if (std::abs(left / steps - now_.dt) < worth_a_change * now_.dt) return;
    now_.steps_left = steps;
    now_.dt = left / steps;
  }

  [[nodiscard]] Moment moment() const {
    State state = motion_.state();
    Moment moment{
        .time = now_.time,
        .load_fraction = fraction(),
        .step = now_.step,
        .displacements = {},
        .reactions = std::vector<Vector3>(state.displacements.size(), Vector3::Zero()),
        .kinetic_energy = 0,
        .strain_energy = body_.forces.strain_energy(state.displacements)};
    std::vector<Vector3> forces(state.displacements.size());
    body_.forces.internal(state, forces);
    for (std::size_t n = 0; n < forces.size(); ++n)
      forces[n] += moment.load_fraction * body_.load[n];
    for (const auto& [node, i, plate] : prescribed_)
      moment.reactions[node][i] = -forces[node][i];
    for (std::size_t n = 0; n < forces.size(); ++n) {
      if (protocol_.integrator == Integrator::verlet)  // from half a step behind
        for (int i = 0; i < 3; ++i)
          if (is_free_[3 * n + static_cast<std::size_t>(i)])
            state.velocities[n][i] += now_.last_dt / 2 * forces[n][i] / body_.masses[n];
      moment.kinetic_energy += body_.masses[n] / 2 * state.velocities[n].squaredNorm();
    }
    moment.displacements = std::move(state.displacements);
    return moment;
  }

  const MarchedBody& body_;
  Motion& motion_;
  const Protocol& protocol_;
  const Observers& observers_;
  std::vector<PrescribedComponent> prescribed_;
  std::vector<bool> is_free_;
  double far_;
  Checkpoint now_;
};

}  // namespace

Solution march(const MarchedBody& body, Motion& motion, const Protocol& protocol,
               const Observers& observers) {
  double limit = 0;
  if (!observers.from) {
    limit = body.stable_step(std::nullopt);
    const auto is_free =
        free_components(body.mesh, prescribed_components(body.mesh, body.scene));
    const std::string reason =
        reason_to_refuse(body, protocol, limit, std::ranges::count(is_free, true) > 0);
    if (!reason.empty()) {
      Solution solution = refused(reason);
      solution.dt = if_finite(protocol.time_step.value_or(safety * limit));
      solution.dt_limit = if_finite(limit);
      return solution;
    }
  }
  return March(body, motion, protocol, observers, limit).run();
}

}  // namespace springcheck::dynamics
