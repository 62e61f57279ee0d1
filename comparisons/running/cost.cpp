#include "comparisons/running/cost.hpp"
#include "comparisons/settings/case_json.hpp"

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace springcheck {
namespace {

constexpr double nodes_there = 1331;  // where the methods' seconds are known
constexpr double growth = 1.3;        // with the nodes, between 10^3 and 30^3 cells

/// Steps get shorter as pressure waves get faster; a step that is given replaces them.
double seconds_of_dynamics(const CaseSettings& settings) {
  constexpr double step_there = 1.14e-3;  // [s] cells of 5 mm, E = 10 kPa, nu = .25
  const auto [lambda, mu] = lame_constants(settings.material);
  const double stiffer = (lambda + 2 * mu) / 1.2e4;
  const double shorter = settings.dynamics.time_step
                             ? step_there / *settings.dynamics.time_step
                             : std::sqrt(stiffer);
  const Seconds& seconds = settings.method.seconds;
  const double in_motion = is_grid_of_hexahedra(settings.body)  // not known of a file
                               ? seconds.in_motion
                               : seconds.in_motion_off_grids;
  return in_motion * shorter * settings.dynamics.duration;
}

double seconds_of(const CaseSettings& settings) {
  const auto [nx, ny, nz] = element_nodes(settings);
  const double larger = nx * ny * nz / nodes_there;
  if (goes_through_time(settings)) return seconds_of_dynamics(settings) * larger;
  return settings.method.seconds.at_rest * std::pow(larger, growth);
}

}  // namespace

void CostEstimate::add(const CaseSettings& settings) {
  const std::string told = settings_json(settings).dump();
  if (seen_.insert(std::hash<std::string>{}(told)).second)
    seconds_ += seconds_of(settings);
}

void CostEstimate::add(const Request& request) {
  add(request.settings);
  for (const CaseSettings& reference : reference_cases(request)) add(reference);
}

}  // namespace springcheck
