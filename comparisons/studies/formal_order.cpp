#include "comparisons/studies/formal_order.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "comparisons/methods/methods.hpp"

namespace springcheck {
namespace {

bool has_glued_edges(const CaseSettings& settings) {
  const TestName& test = entry_of(settings.test);
  const bool slides = test.slides || (settings.test == Test::traction &&
                                      settings.plates == PlateContact::sliding);
  return test.lower_plate && !slides;
}

/// Poisson's ratio of the continuum: the method's own, or its lattice's, where they have
/// one.
double poisson_ratio_of(const CaseSettings& settings) {
  const Method* springs = &settings.method;
  if (reads(settings.method, "lattice"))
    springs = find_method(settings.elements.lattice.name);
  if (springs != nullptr && springs->own_poisson_ratio)
    return *springs->own_poisson_ratio;
  return settings.material.poisson_ratio;
}

}  // namespace

double clamped_edge_exponent(double nu) {
  assert(nu < 0.5);
  const double k = 3 - 4 * nu;
  if (k >= 3) return 1;
  const auto is_below_root = [&](double a) {
    const double sine = std::sin(a * std::numbers::pi / 2);
    return k * sine * sine < (1 + k) * (1 + k) / 4 - a * a;
  };
  double low = 0, high = 1;
  for (int i = 0; i < std::numeric_limits<double>::digits; ++i) {
    const double middle = (low + high) / 2;
    (is_below_root(middle) ? low : high) = middle;
  }
  return high;
}

double formal_order(const CaseSettings& settings) {
  const double of_cells =
      reads(settings, "element") ? settings.elements.element.order : 2;
  if (!has_glued_edges(settings)) return of_cells;
  constexpr double of_any_angle = 1;
  if (settings.body.shape != BodyShape::block) return of_any_angle;
  return std::min(of_cells, 2 * clamped_edge_exponent(poisson_ratio_of(settings)));
}

}  // namespace springcheck
