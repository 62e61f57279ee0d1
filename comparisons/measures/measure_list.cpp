#include "comparisons/measures/measure_list.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace springcheck {

const Measure* find_measure(std::string_view name) {
  const auto found = std::ranges::find(measure_list, name, &Measure::name);
  return found == measure_list.end() ? nullptr : &*found;
}

std::string_view shown_unit(const Measure& measure) {
  return measure.traits.in_percent ? "%" : measure.unit;
}

double shown_factor(const Measure& measure) {
  return measure.traits.in_percent ? 100 : 1;
}

std::string heading_of(const Measure& measure) {
  const std::string_view unit = shown_unit(measure);
  return unit.empty() ? std::string(measure.label)
                      : fmt::format("{} [{}]", measure.label, unit);
}

std::size_t component_count(const Measure& measure) {
  constexpr std::size_t counts[] = {1, 3, 9};  // in the order of Measure::Member
  return counts[measure.member.index()];
}

}  // namespace springcheck
