#include "dynamics/marching/march.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "dynamics/marching/march_checks.hpp"
#include "meshing/basics/breakdown.hpp"
#include "meshing/loads/traction.hpp"

namespace springcheck::dynamics {
namespace {

constexpr int steps_between_checks = 100;
constexpr int steps_between_looks = 1000;  // at the limit
constexpr int looks_per_load = 40;
constexpr double worth_a_change = 0.02;  // of an open step
constexpr double lost = 100;             // body sizes
constexpr double turned_round = 0.5;     // alternation
constexpr double seconds_between_progress = 0.5;

std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// A whole number of steps of about `wanted` in `time`.
int step_count(double time, double wanted) {
  return static_cast<int>(std::max(1., std::ceil(time / wanted - 1e-9)));
}

class March {
 public:
  March(const MarchedBody& body, Motion& motion, const Protocol& protocol,
        const Observers& observers, const StableStep& at_rest)
      : body_(body),
        motion_(motion),
        protocol_(protocol),
        observers_(observers),
        path_(protocol.load.empty() ? ramp(protocol.duration) : protocol.load),
        turns_(turning_points(path_)),
        load_(load_forces(body.mesh, body.scene, body.masses)),
        prescribed_(prescribed_components(body.mesh, body.scene)),
        is_free_(free_components(body.mesh, prescribed_)),
        far_(lost * body_size(body.mesh.nodes())) {
    if (observers.from) {
      now_ = *observers.from;
      motion_.restore(now_.state);
      return;
    }
    now_.limit = at_rest.limit;
    now_.stiffest = at_rest.mode;
    now_.look_evaluations = at_rest.force_evaluations;
    now_.steps_left =
        step_count(protocol.duration,
                   protocol.time_step.value_or(protocol.step_ratio * at_rest.limit));
    now_.dt = protocol.duration / now_.steps_left;
    note_excess();
  }

  Solution run() {
    Solution solution{.status = SolveStatus::ok,
                      .lever_arms = body_.lever_arms,
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
      const bool is_checked =
          (now_.step + 1) % steps_between_checks == 0 || now_.steps_left == 1;
      std::vector<Vector3> velocities_before;
      if (is_checked && now_.excess) velocities_before = motion_.state().velocities;
      --now_.steps_left;
      // The last step ends where the protocol does, to the bit.
      now_.time = now_.steps_left == 0 ? protocol_.duration : now_.time + now_.dt;
      motions = support_motions(body_.scene, fraction());
      advance({.dt = now_.dt,
               .kick = kick,
               .load_fraction = fraction(),
               .motions_before = std::move(before),
               .motions = motions});
      now_.last_dt = now_.dt;
      ++now_.step;
      const bool at_end = now_.steps_left == 0;
      if (is_checked) solution.reason = what_blew_up(velocities_before);
      if (!solution.reason.empty()) {
        solution.status = SolveStatus::diverged;
        break;
      }
      if (is_time_of_look() && !at_end) look_at_limit();
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
    if (solution.status == SolveStatus::ok && now_.excess)
      solution.reason = above_limit(body_, protocol_, *now_.excess);
    Moment end = moment();
    solution.steps = now_.step;
    solution.force_evaluations = now_.step + 1 + now_.look_evaluations;
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
  [[nodiscard]] double fraction() const { return load_fraction(path_, now_.time); }

  /// Whether one of so many equal parts of a piece of the path ended in the step just
  /// made.
  [[nodiscard]] bool ended_part_of(const LoadPath& path, int parts) const {
    const auto passed = [&](double time) {
      return std::floor(pieces_passed(path, time) * parts + 1e-9);
    };
    return passed(now_.time) > passed(now_.time - now_.last_dt);
  }
  [[nodiscard]] bool is_time_of_sample() const {
    return now_.steps_left == 0 || ended_part_of(path_, observers_.samples);
  }
  [[nodiscard]] bool is_time_of_look() const {
    return protocol_.integrator != Integrator::implicit_euler &&
           (now_.step % steps_between_looks == 0 ||
            ended_part_of(turns_, looks_per_load));
  }

  /// What ends the march as diverged, if anything does.
  [[nodiscard]] std::string what_blew_up(
      const std::vector<Vector3>& velocities_before) const {
    const State here = motion_.state();
    const std::string step = fmt::format("by step {} of {} (t = {:.4g} s", now_.step,
                                         now_.step + now_.steps_left, now_.time);
    if (!(longest(here.displacements) < far_))
      return fmt::format("positions left all bounds {}, dt = {:.4g} s{})", step, now_.dt,
                         std::isfinite(now_.limit)
                             ? fmt::format(", stability limit {:.4g} s", now_.limit)
                             : "");
    if (!velocities_before.empty() &&
        alternation(body_.masses, velocities_before, here.velocities) > turned_round)
      return fmt::format("velocities turned round from step to step {}); {}", step,
                         above_limit(body_, protocol_, *now_.excess));
    return {};
  }

  void advance(const StepTo& step) {
    try {
      motion_.advance(step);
    } catch (const Breakdown& error) {
      throw Breakdown(fmt::format("step {} (t = {:.4g} s): {}", now_.step + 1, now_.time,
                                  error.what()));
    }
  }

  void look_at_limit() {
    const StableStep known{.limit = now_.limit, .mode = std::move(now_.stiffest)};
    StableStep found = body_.stable_step(motion_.state(), &known);
    now_.limit = found.limit;
    now_.stiffest = std::move(found.mode);
    now_.look_evaluations += found.force_evaluations;
    note_excess();
    if (!protocol_.time_step) follow_limit();
  }

  void note_excess() {
    if (now_.excess || !(now_.dt > now_.limit)) return;
    now_.excess = {.step = now_.step, .dt = now_.dt, .limit = now_.limit};
    spdlog::warn("{}", above_limit(body_, protocol_, *now_.excess));
  }

  void follow_limit() {
    const double left = protocol_.duration - now_.time;
    // Where the limit allows no countable number of steps, the step stays as it is: going
    // on shows what becomes of the motion.
    if (!std::isfinite(now_.limit) || !(left / (protocol_.step_ratio * now_.limit) <
                                        std::numeric_limits<int>::max() - now_.step))
      return;
    const int steps = step_count(left, protocol_.step_ratio * now_.limit);
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
        .reactions = std::vector<Vector3>(state.displacements.size(), Vector3::Zero()),
        .lever_arms = body_.lever_arms,
        .kinetic_energy = 0,
        .strain_energy = body_.forces.strain_energy(state.displacements)};
    std::vector<Vector3> forces = body_.forces.internal(state);
    for (std::size_t n = 0; n < forces.size(); ++n)
      forces[n] += moment.load_fraction * load_[n];
    for (const auto& [node, i, plate] : prescribed_)
      moment.reactions[node][i] = -forces[node][i];
    for (std::size_t n = 0; n < forces.size(); ++n) {
      double square = state.velocities[n].squaredNorm();
      if (protocol_.integrator == Integrator::verlet)  // mean of half a step either way
        square = (square + velocity_after(state, forces, n).squaredNorm()) / 2;
      moment.kinetic_energy += body_.masses[n] / 2 * square;
    }
    moment.displacements = std::move(state.displacements);
    return moment;
  }

  /// Verlet's velocity of a node after the next half step.
  [[nodiscard]] Vector3 velocity_after(const State& state,
                                       const std::vector<Vector3>& forces,
                                       std::size_t n) const {
    Vector3 v = state.velocities[n];
    for (int i = 0; i < 3; ++i)
      if (is_free_[3 * n + static_cast<std::size_t>(i)])
        v[i] += now_.last_dt * forces[n][i] / body_.masses[n];
    return v;
  }

  const MarchedBody& body_;
  Motion& motion_;
  const Protocol& protocol_;
  const Observers& observers_;
  LoadPath path_, turns_;
  std::vector<Vector3> load_;  // [N] at the full load
  std::vector<PrescribedComponent> prescribed_;
  std::vector<bool> is_free_;
  double far_;
  Checkpoint now_;
};

}  // namespace

Solution march(const MarchedBody& body, Motion& motion, const Protocol& protocol,
               const Observers& observers, const Stopwatch& setup) {
  StableStep at_rest{.limit = 0};
  if (!observers.from) {
    at_rest = body.stable_step(std::nullopt, nullptr);
    const auto is_free =
        free_components(body.mesh, prescribed_components(body.mesh, body.scene));
    const std::string reason = reason_to_refuse(body, protocol, at_rest.limit,
                                                std::ranges::count(is_free, true) > 0);
    if (!reason.empty()) {
      Solution solution = refused(reason);
      solution.dt =
          if_finite(protocol.time_step.value_or(protocol.step_ratio * at_rest.limit));
      solution.dt_limit = if_finite(at_rest.limit);
      return solution;
    }
  }
  const double setup_wall_s = setup.seconds();
  Solution solution = March(body, motion, protocol, observers, at_rest).run();
  solution.setup_wall_s = setup_wall_s;
  return solution;
}

}  // namespace springcheck::dynamics
