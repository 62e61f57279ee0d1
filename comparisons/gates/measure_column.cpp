#include "comparisons/gates/measure_column.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>

#include "comparisons/measures/measure_list.hpp"
#include "comparisons/names/suggestion.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck::gates {
namespace {

/// Numbers in a row of each column, whether or not the cases have it.
std::map<std::string, std::size_t> widths(const Columns& cases) {
  std::map<std::string, std::size_t> widths;
  for (const Measure& measure : measure_list)
    widths.emplace(measure.name, component_count(measure));
  for (const auto& [name, column] : cases.numbers) widths[name] = column.width;
  return widths;
}

}  // namespace

MeasureColumn measure_column(const std::string& name, const Columns& cases,
                             const std::string& place) {
  const auto known = widths(cases);
  const std::size_t dot = name.rfind('.');
  const bool is_whole = dot == std::string::npos || known.contains(name);
  const std::string column = is_whole ? name : name.substr(0, dot);
  const std::string component = is_whole ? "" : name.substr(dot + 1);
  const auto width = known.find(column);
  if (width == known.end()) {
    const auto all = known | std::views::keys;
    refuse_name(place, "measure", name, {all.begin(), all.end()});
  }
  if (width->second == 1 && component.empty())
    return {.name = name, .column = column, .component = 0};
  const auto names = component_names(width->second);
  const auto found = std::ranges::find(names, component);
  if (found == names.end())
    throw InputError(
        place, "measure",
        !names.empty()
            ? fmt::format("'{}.' and one of {}", column, fmt::join(names, ", "))
        : width->second == 1 ? fmt::format("'{}', which has no components", column)
                             : "a number, or one of a vector or a matrix",
        "'" + name + "'");
  return {.name = name,
          .column = column,
          .component = static_cast<std::size_t>(found - names.begin())};
}

std::optional<double> value_of(const MeasureColumn& measure, const Columns& cases,
                               std::size_t row) {
  const auto column = cases.numbers.find(measure.column);
  if (column == cases.numbers.end()) return std::nullopt;
  const auto& [width, values] = column->second;
  const double value = values[row * width + measure.component];
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool is_time(const MeasureColumn& measure) {
  const Measure* known = find_measure(measure.column);
  return known != nullptr && known->traits.is_time;
}

}  // namespace springcheck::gates
