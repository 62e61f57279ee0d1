#include "mss/dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mss/forces.hpp"
#include "mss/time_step.hpp"

namespace springcheck::mss {
namespace {

constexpr double safety = 0.9;  // of the stability limit, for time_step = none
constexpr int steps_between_checks = 100;
constexpr double lost = 100;  // body sizes

/// Forces on every node: springs, correction, dashpots and the fraction of the load.
void total_forces(const Network& network, double damping_ratio, double load_fraction,
                  const std::vector<Vector3>& load, const std::vector<Vector3>& x,
                  const std::vector<Vector3>& v, CellStates& states,
                  std::vector<Vector3>& forces) {
  nodal_forces(network, x, states, forces);
  if (damping_ratio > 0) add_dashpot_forces(network, damping_ratio, x, v, forces);
  for (std::size_t n = 0; n < x.size(); ++n) forces[n] += load_fraction * load[n];
}

double body_size(const std::vector<Vector3>& nodes) {
  Vector3 low = nodes.front(), high = low;
  for (const Vector3& x : nodes) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).norm();
}

std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

Solution run_dynamics(const Mesh& mesh, const Scene& scene, const Network& network,
                      const DynamicsSettings& settings) {
  const auto prescribed = prescribed_components(mesh, scene);
  const std::vector<bool> is_free = free_components(mesh, prescribed);
  const std::vector<Vector3> load = load_forces(mesh, scene, network);

  const double limit = largest_stable_step(network, settings.damping_ratio, is_free);
  const double wanted = settings.time_step.value_or(safety * limit);
  const double step_count = std::max(1., std::ceil(settings.duration / wanted - 1e-9));
  std::string reason;
  if (wanted > limit && !settings.force_time_step)
    reason = fmt::format(
        "dt = {:.4g} s is above the stability limit {:.4g} s of this mesh, material and "
        "damping; force-dt runs it all the same",
        wanted, limit);
  if (step_count > std::numeric_limits<int>::max())
    reason = fmt::format("dt = {:.4g} s needs {:.3g} steps, more than can be counted",
                         wanted, step_count);
  if (std::isinf(wanted) && std::ranges::count(is_free, true) > 0)
    reason =
        "dt = auto has no swing to go by: no motion about the rest state has a positive "
        "stiffness";
  if (!reason.empty()) {
    Solution solution = refused(reason);
    solution.dt = if_finite(wanted);
    solution.dt_limit = if_finite(limit);
    return solution;
  }
  const int steps = static_cast<int>(step_count);
  const double dt = settings.duration / steps;

  std::vector<Vector3> x = mesh.nodes(), v(x.size(), Vector3::Zero()), forces(x.size());
  CellStates states;
  const double far = lost * body_size(mesh.nodes());
  const auto escaped = [&] {
    return std::ranges::any_of(
        x, [&](const Vector3& p) { return !p.allFinite() || p.norm() > far; });
  };
  Solution solution{.status = SolveStatus::ok,
                    .reason = {},
                    .displacements = {},
                    .reactions = {},
                    .lever_arms = LeverArms::deformed,
                    .strain_energy = 0,
                    .load_fraction = 0,
                    .steps = 0,
                    .force_evaluations = 0,
                    .dt = dt,
                    .dt_limit = if_finite(limit)};
  for (int step = 1; step <= steps; ++step) {
    const double fraction = static_cast<double>(step) / steps;
    total_forces(network, settings.damping_ratio, fraction, load, x, v, states, forces);
    for (const PrescribedComponent& held : prescribed) {
      const auto& [node, i, plate] = held;
      const double next =
          mesh.nodes()[node][i] + prescribed_displacement(mesh, scene, held, fraction);
      v[node][i] = (next - x[node][i]) / dt;
      forces[node][i] = 0;
    }
    for (std::size_t n = 0; n < x.size(); ++n) {
      v[n] += dt / network.masses[n] * forces[n];
      x[n] += dt * v[n];
    }
    solution.steps = step;
    solution.load_fraction = fraction;
    if ((step % steps_between_checks == 0 || step == steps) && escaped()) {
      solution.status = SolveStatus::diverged;
      solution.reason = fmt::format(
          "positions left all bounds by step {} of {} (t = {:.4g} s, dt = {:.4g} s, "
          "stability limit at rest {:.4g} s)",
          step, steps, step * dt, dt, limit);
      break;
    }
  }
  total_forces(network, settings.damping_ratio, solution.load_fraction, load, x, v,
               states, forces);
  solution.force_evaluations = solution.steps + 1;
  solution.strain_energy = strain_energy(network, x);
  solution.reactions.assign(x.size(), Vector3::Zero());
  for (const auto& [node, i, plate] : prescribed)
    solution.reactions[node][i] = -forces[node][i];
  for (std::size_t n = 0; n < x.size(); ++n)
    solution.displacements.push_back(x[n] - mesh.nodes()[n]);
  return solution;
}

}  // namespace springcheck::mss
