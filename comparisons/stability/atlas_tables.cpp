#include "comparisons/stability/atlas_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "comparisons/measures/measure_list.hpp"
#include "comparisons/settings/value_range.hpp"

namespace springcheck {
namespace {

/// Letters by the first axis's value and the second's, of one method.
using Map = std::map<std::pair<std::string, std::string>, char>;

std::string map_text(const Map& map, const AtlasPlan& plan) {
  const bool is_plane = plan.axes.size() == 2;
  const std::vector<std::string> across =
      is_plane ? plan.axes[1].values : std::vector<std::string>{""};
  std::size_t width = 0;
  for (const std::string& value : plan.axes[0].values)
    width = std::max(width, short_text(value).size());
  std::string text;
  for (auto value = plan.axes[0].values.rbegin(); value != plan.axes[0].values.rend();
       ++value) {
    text += fmt::format("  {:>{}} ", short_text(*value), width);
    for (const std::string& other : across) {
      const auto found = map.find({*value, other});  // labels may hold an axis: element
      text += fmt::format(" {}", found != map.end() ? found->second : ' ');
    }
    text += '\n';
  }
  if (is_plane)
    text += fmt::format("  {:>{}}  {} from {} to {}\n", "", width, plan.axes[1].key,
                        short_text(across.front()), short_text(across.back()));
  return text;
}

}  // namespace

Table points_table(const Atlas& atlas, const AtlasPlan& plan) {
  Table table{.name = "stability-points",
              .title = fmt::format("Where methods fail in {}", plan.scene),
              .columns = {{"method", "method"}}};
  for (const Axis& axis : plan.axes) table.columns.push_back({axis.key, axis.key});
  table.columns.push_back({"failure", "failure"});
  table.columns.push_back({"status", "status"});
  for (const auto& [name, format] :
       std::initializer_list<std::pair<const char*, const char*>>{
           {"wrinkle_alternation", "{:.3f}"},
           {"wrinkle_amplitude", "{:.3g}"},
           {"hourglass_alternation", "{:.3f}"},
           {"hourglass_amplitude", "{:.3g}"},
           {"corner_jacobian_ratio_min", "{:.3g}"},
           {"definite_up_to_deformation", "{:.4g}"}})
    table.columns.push_back({name, heading_of(*find_measure(name)), format});
  table.columns.push_back({"dt_limit", "step limit [s]", "{:.4g}"});
  for (const AtlasPoint& point : atlas.points) {
    const Measures& m = point.result.measures;
    TableRow row{.cells = {point.method}, .cases = {point.result.key}};
    for (const std::string& value : point.values) row.cells.push_back(value);
    row.cells.insert(row.cells.end(),
                     {name_of(point.failure), name_of(point.result.status),
                      m.wrinkle_alternation, m.wrinkle_amplitude, m.hourglass_alternation,
                      m.hourglass_amplitude, m.corner_jacobian_ratio_min,
                      m.definite_up_to_deformation, point.result.solution.dt_limit});
    if (!point.result.revision.empty())
      row.notes.push_back(
          fmt::format("Of revision {} of the numerics.", point.result.revision));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table limits_table(const Atlas& atlas, const AtlasPlan& plan) {
  const Axis& along = plan.axes[0];
  const std::string unit = along.is_range && !unit_of(along.values[0]).empty()
                               ? fmt::format(" [{}]", unit_of(along.values[0]))
                               : "";
  Table table{
      .name = "stability-limits",
      .title = fmt::format("Limits along {} in {}", along.key, plan.scene),
      .columns = {{"method", "method"}},
      .notes = {
          "A method holds up to the one and fails at the other value, within 1 % of "
          "it; none: it fails from the first value on, holds to the last, or what "
          "failed tells nothing of the body. Limits along a positive deformation are "
          "of the path from rest, where it loses its stability or a cell is turned "
          "inside out, within .2 %. Beyond it the map may show another stable state."}};
  if (along.key == "dt" || along.key == "dt-ratio")
    table.notes.push_back(
        "Limits of steps are of the duration that was run: a motion just above its limit "
        "takes long to grow.");
  if (plan.axes.size() == 2)
    table.columns.push_back({plan.axes[1].key, plan.axes[1].key});
  for (const Column& column :
       std::initializer_list<Column>{{"holds", "holds at" + unit, "{:.5g}"},
                                     {"fails", "fails at" + unit, "{:.5g}"},
                                     {"failure", "by"},
                                     {"wavelength", "mode [edges]", "{:.3g}"},
                                     {"reason", "reason"}})
    table.columns.push_back(column);
  for (const AtlasLimit& limit : atlas.limits) {
    TableRow row{.cells = {limit.method}, .cases = limit.cases};
    if (plan.axes.size() == 2) row.cells.push_back(limit.other.value());
    row.cells.insert(row.cells.end(), {{limit.low, "none"},
                                       {limit.high, "none"},
                                       name_of(limit.failure),
                                       limit.wavelength,
                                       limit.reason});
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string maps_text(const Atlas& atlas, const AtlasPlan& plan) {
  std::vector<std::string> methods;
  std::map<std::string, Map> maps;
  std::map<Failure, int> seen;
  for (const AtlasPoint& point : atlas.points) {
    if (!maps.contains(point.method)) methods.push_back(point.method);
    const std::string other = point.values.size() > 1 ? point.values[1] : "";
    maps[point.method][{point.values[0], other}] = entry_of(point.failure).letter;
    ++seen[point.failure];
  }
  std::string text;
  for (const std::string& method : methods)
    text += fmt::format("{}: {}{}\n{}\n", method, plan.axes[0].key,
                        plan.axes.size() == 2 ? " against " + plan.axes[1].key : "",
                        map_text(maps.at(method), plan));
  for (const auto& [failure, count] : seen)
    text +=
        fmt::format("{}  {} ({})\n", entry_of(failure).letter, name_of(failure), count);
  return text;
}

}  // namespace springcheck
