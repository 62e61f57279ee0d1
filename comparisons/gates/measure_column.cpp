#include "comparisons/gates/measure_column.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>
#include <vector>

#include "comparisons/measures/measures.hpp"
#include "meshing/input_error.hpp"

namespace springcheck::gates {
namespace {

/// Numbers in a row of each column, whether or not the cases have it.
std::map<std::string, std::size_t> widths(const Columns& cases) {
  std::map<std::string, std::size_t> widths{{"solve_wall_s", 1}, {"wall_s", 1}};
  const Measures none;
  for_each_measure(none, [&](const char* name, const auto& value) {
    using Measure = std::decay_t<decltype(value)>;
    if (std::is_same_v<Measure, Measures::Vector>)
      widths[name] = 3;
    else if (std::is_same_v<Measure, Measures::Matrix>)
      widths[name] = 9;
    else
      widths[name] = 1;
  });
  for (const auto& [name, column] : cases.numbers) widths[name] = column.width;
  return widths;
}

std::vector<std::string> components(std::size_t width) {
  if (width == 1) return {""};
  if (width == 9) return {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
  return {"x", "y", "z"};
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
    std::vector<std::string> names;
    for (const auto& [one, _] : known) names.push_back(one);
    throw InputError(place, "measure", fmt::format("one of {}", fmt::join(names, ", ")),
                     "'" + name + "'");
  }
  const std::vector<std::string> all = components(width->second);
  const auto found = std::ranges::find(all, component);
  if (found == all.end())
    throw InputError(
        place, "measure",
        all.size() == 1
            ? fmt::format("'{}', which has no components", column)
            : fmt::format("'{}.' and one of {}", column, fmt::join(all, ", ")),
        "'" + name + "'");
  return {.name = name,
          .column = column,
          .component = static_cast<std::size_t>(found - all.begin())};
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
  return measure.column == "wall_s" || measure.column == "solve_wall_s";
}

}  // namespace springcheck::gates
