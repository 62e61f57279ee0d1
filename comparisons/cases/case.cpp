#include "comparisons/cases/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ranges>

namespace springcheck {

CaseSettings at_load(CaseSettings settings, double fraction) {
  if (settings.deformation) *settings.deformation *= fraction;
  settings.gravity *= fraction;
  settings.traction *= fraction;
  settings.gradient *= fraction;
  return settings;
}

double last_load(const Dynamics& dynamics) {
  return dynamics.load.empty() ? 1 : dynamics.load.back().fraction;
}

CaseSettings at_last_load(const CaseSettings& settings) {
  if (has_history(settings) || solver_of(settings) == Solver::path_limit) return settings;
  CaseSettings there = at_load(settings, last_load(settings.dynamics));
  there.dynamics.load.clear();
  there.dynamics.oscillation.reset();
  return there;
}

CaseSettings at_largest_load(const CaseSettings& settings, double reached) {
  double largest = std::abs(reached);
  if (has_history(settings))
    for (const dynamics::LoadPoint& point : settings.dynamics.load)
      largest = std::max(largest, std::abs(point.fraction));
  return at_load(settings, largest);
}

bool acts_backwards(const CaseSettings& settings, double reached) {
  double acted = reached;
  if (has_history(settings))
    for (const dynamics::LoadPoint& point : std::views::reverse(settings.dynamics.load))
      if (acted == 0) acted = point.fraction;
  return acted < 0;
}

CaseSettings in_last_direction(const CaseSettings& settings, double reached) {
  return at_load(settings, acts_backwards(settings, reached) ? -1 : 1);
}

CaseSettings without_noise(CaseSettings settings) {
  // Seeds of noise then tell one case from another no more.
  if (settings.search.noise > 0)
    settings.search = {.linear_solver = settings.search.linear_solver};
  return settings;
}

bool has_load(const CaseSettings& settings) {
  return settings.deformation.value_or(0) != 0 || !settings.gravity.isZero(0) ||
         !settings.traction.isZero(0) || !settings.gradient.isZero(0);
}

Solver solver_of(const CaseSettings& settings) {
  const Method& method = settings.method;
  const auto has = [&](Solver solver) {
    return std::ranges::count(method.solvers, solver) > 0;
  };
  if (settings.solver && (method.follows_solver || has(*settings.solver)))
    return *settings.solver;
  return method.solvers.empty() ? Solver::static_equilibrium : method.solvers.front();
}

bool goes_through_time(const CaseSettings& settings) {
  const Solver solver = solver_of(settings);
  return solver != Solver::static_equilibrium && solver != Solver::path_limit;
}

bool needs_tangents(const CaseSettings& settings) {
  return !goes_through_time(settings) || solver_of(settings) == Solver::implicit_euler;
}

bool has_history(const CaseSettings& settings) {
  return goes_through_time(settings) || settings.method.has_history;
}

mss::NetworkSettings springs_of(const CaseSettings& settings, const FixedSprings& fixed) {
  const mss::NetworkSettings usual{.model = settings.springs.model};
  mss::NetworkSettings springs = settings.springs;
  if (!reads(settings, "spring-strain"))
    springs.strain_measure = fixed.strain.value_or(usual.strain_measure);
  if (!reads(settings, "directions")) springs.axes = fixed.axes.value_or(usual.axes);
  if (!reads(settings, "diagonal-ratio"))
    springs.diagonal_ratio = fixed.diagonal_ratio.value_or(usual.diagonal_ratio);
  return springs;
}

std::array<double, 3> element_nodes(const CaseSettings& settings) {
  const int divisions =
      reads(settings.method, "element") ? settings.elements.element.divisions : 1;
  std::array<double, 3> nodes = equivalent_grid(settings.body);
  for (double& count : nodes) count = divisions * count + 1;
  return nodes;
}

std::string label(const CaseSettings& settings) {
  if (!reads(settings.method, "element")) return settings.method.name;
  return fmt::format("{}:{}", settings.method.name, settings.elements.element.name);
}

}  // namespace springcheck
