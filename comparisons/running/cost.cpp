#include "comparisons/running/cost.hpp"
#include "comparisons/settings/case_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

namespace springcheck {
namespace {

// Seconds of one core on 10^3 cells at 5 to 20 %, means over nu from 0 to .499 of the
// five tests: springs .25 to 1.6 (wrinkling ones most), Hooke .1, other laws .3 to .7.
constexpr double springs = 0.5, hooke = 0.1, other_laws = 0.6;
constexpr double nodes_there = 1331;
constexpr double growth = 1.3;  // with the nodes, between 10^3 and 30^3 cells

// And of a simulated second at nu = .25 with steps of .9 of the limit: .037 and .042 by
// kernels, .1 by mss-affine's, .66 by plain loops; measured with what is done once, about
// half of the first.
constexpr double by_kernels = 0.03, by_affine_kernel = 0.1, by_plain_loops = 0.6;

double per_simulated_second(const CaseSettings& settings) {
  const auto* springs_of = std::get_if<mss::Method>(&settings.method.model);
  if (springs_of == nullptr) return by_kernels;
  switch (*springs_of) {
    case mss::Method::affine:  // of a mesh file nothing is known
      return is_grid_of_hexahedra(settings.body) ? by_affine_kernel : by_plain_loops;
    case mss::Method::vangelder:
    case mss::Method::lloyd:
      return by_plain_loops;
    default:
      return by_kernels;
  }
}

/// Steps get shorter as pressure waves get faster; a step that is given replaces them.
double seconds_of_dynamics(const CaseSettings& settings) {
  constexpr double step_there = 1.14e-3;  // [s] cells of 5 mm, E = 10 kPa, nu = .25
  const auto [lambda, mu] = lame_constants(settings.material);
  const double stiffer = (lambda + 2 * mu) / 1.2e4;
  const double shorter = settings.dynamics.time_step
                             ? step_there / *settings.dynamics.time_step
                             : std::sqrt(stiffer);
  return per_simulated_second(settings) * shorter * settings.dynamics.duration;
}

double seconds(const CaseSettings& settings) {
  const bool is_fem = is_finite_element(settings.method);
  const bool halved = is_fem && settings.elements.element.element ==
                                    fem_reference::Element::q2;  // q2's own nodes
  double nodes = 1;
  for (const double cells : equivalent_grid(settings.body))
    nodes *= (halved ? 2. : 1.) * cells + 1;
  const double larger = nodes / nodes_there;
  if (goes_through_time(settings)) return seconds_of_dynamics(settings) * larger;
  const bool is_linear = settings.method.name == "fem-hooke";
  const double there = !is_fem ? springs : is_linear ? hooke : other_laws;
  return there * std::pow(larger, growth);
}

}  // namespace

double estimated_seconds(const std::vector<Request>& requests) {
  double total = 0;
  std::set<std::string> seen;
  const auto add = [&](const CaseSettings& settings) {
    if (seen.insert(settings_json(settings).dump()).second) total += seconds(settings);
  };
  for (const Request& request : requests) {
    add(request.settings);
    for (const CaseSettings& reference : reference_cases(request)) add(reference);
  }
  return total;
}

}  // namespace springcheck
