#include "comparisons/tables/all_cases_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "comparisons/measures/measure_list.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/results/case_table.hpp"
#include "comparisons/settings/setting.hpp"

namespace springcheck {
namespace {

/// A measure among the columns.
struct Shown {
  std::string_view measure, format;
  bool is_answer = false;  // shown in tests that it answers; in others it is round-off
};

constexpr Shown shown_measures[] = {
    {"volume_error", "{:.4f}"},          {"plate_force_norm", "{:.5g}"},
    {"plate_torque", "{:.5g}", true},    {"tip_deflection", "{:.5g}"},
    {"cell_volume_ratio_min", "{:.4f}"}, {"deviation_l2_relative", "{:.3f}"},
    {"solve_wall_s", "{:.2g}"}};

std::string text(const Columns& cases, const std::string& column, std::size_t row) {
  const auto found = cases.texts.find(column);
  return found == cases.texts.end() ? std::string() : found->second[row];
}

std::optional<double> number(const Columns& cases, const std::string& column,
                             std::size_t row, std::size_t component = 0) {
  const auto found = cases.numbers.find(column);
  if (found == cases.numbers.end()) return std::nullopt;
  const double value = found->second.values[found->second.width * row + component];
  if (std::isnan(value)) return std::nullopt;
  return value;
}

/// "fem-stvk:q1-sri", "mss-cf, E-form, A = 0.5", "mss-cf, verlet".
std::string method_of(const Columns& cases, std::size_t row) {
  std::string name = text(cases, "method", row);
  if (const auto element = text(cases, "element", row); !element.empty())
    name += ":" + element;
  for (const Setting& setting : all_settings()) {
    if (setting.variant.empty()) continue;
    const std::string key(setting.key);
    const auto value = number(cases, key, row);
    const std::string words = value ? fmt::format("{:g}", *value) : text(cases, key, row);
    name += variant_of(setting, words);
  }
  const Method* method = find_method(text(cases, "method", row));
  const std::string solver = text(cases, "solver", row);
  if (method != nullptr && !solver.empty() && solver != name_of(method->solvers.front()))
    name += ", " + solver;
  return name;
}

/// "10x10x10 hexahedron"; of files' meshes the beginning of their hash, of other bodies
/// their name.
std::string mesh_of(const Columns& cases, std::size_t row) {
  const std::string body = text(cases, "body", row);
  if (body == "file") return "mesh " + text(cases, "mesh", row).substr(0, 8);
  if (body != "block" || !number(cases, "cells", row)) return body;
  std::string mesh =
      fmt::format("{:.0f}x{:.0f}x{:.0f} {}", *number(cases, "cells", row),
                  *number(cases, "cells", row, 1), *number(cases, "cells", row, 2),
                  text(cases, "cell-type", row));
  if (const auto distortion = number(cases, "distortion", row); distortion > 0)
    mesh += fmt::format(", distorted by {:g}", *distortion);
  return mesh;
}

TableRow row_of(const Columns& cases, std::size_t row) {
  const std::string status = text(cases, "status", row);
  TableRow shown{
      .cells = {text(cases, "scene", row), method_of(cases, row), mesh_of(cases, row),
                number(cases, "nu", row), number(cases, "young", row),
                number(cases, "deformation", row), status},
      .cases = {text(cases, "key", row)}};
  const TestName* test = find_value<Test>(text(cases, "test", row));
  for (const auto& [name, format, is_answer] : shown_measures) {
    const bool is_shown = !is_answer || (test != nullptr && test->answer == name);
    Cell cell = is_shown ? number(cases, std::string(name), row) : std::nullopt;
    if (cell.number) *cell.number *= shown_factor(*find_measure(name));
    shown.cells.push_back(cell);
  }
  if (const auto part = number(cases, "load_fraction", row);
      part && *part != 1 && number(cases, "volume_change", row))
    shown.notes.push_back(fmt::format("Ends at {:g} % of the load.", 100 * *part));
  shown.cells.push_back(text(cases, "reference", row));
  if (const std::string other = text(cases, "other_revision", row); !other.empty())
    shown.notes.push_back(fmt::format("Of revision {} of the numerics.", other));
  return shown;
}

/// "solver verlet, duration 4": the settings that differ between those rows, in words.
std::string words_of(const Columns& cases, const std::vector<std::string>& keys,
                     std::size_t row) {
  std::vector<std::string> words;
  for (const std::string& key : keys)
    if (const std::string value = value_at(cases, key, row); !value.empty())
      words.push_back(key + " " + value);
  return fmt::format("{}", fmt::join(words, ", "));
}

/// What tells each row from others that read alike; by places in the file.
std::map<std::size_t, std::string> further_settings(const Columns& cases) {
  std::map<std::vector<std::string>, std::vector<std::size_t>> alike;
  for (std::size_t row = 0; row < cases.rows; ++row) {
    std::vector<std::string> shown{text(cases, "scene", row), method_of(cases, row),
                                   mesh_of(cases, row), text(cases, "reference", row)};
    for (const char* key : {"nu", "young", "deformation"})
      shown.push_back(fmt::format("{:g}", number(cases, key, row).value_or(0)));
    alike[shown].push_back(row);
  }
  std::map<std::size_t, std::string> words;
  for (const auto& [shown, rows] : alike) {
    if (rows.size() == 1) continue;
    const std::vector<std::string> keys = differing_settings(cases, rows);
    for (const std::size_t row : rows) words[row] = words_of(cases, keys, row);
  }
  return words;
}

}  // namespace

Table all_cases_table(const Columns& cases) {
  Table table{
      .name = "cases",
      .title = "All cases",
      .columns = {{"scene", "scene"},
                  {"method", "method"},
                  {"mesh", "mesh"},
                  {"nu", "nu", "{:g}"},
                  {"young", "E [Pa]", "{:g}"},
                  {"deformation", "deformation [-, rad]", "{:.4g}"},
                  {"status", "status"}},
      .notes = {"Deviation: volume-weighted root mean square over the free nodes, "
                "from the reference, over the largest imposed displacement."}};
  for (const auto& [name, format, is_answer] : shown_measures)
    table.columns.push_back(
        {std::string(name), heading_of(*find_measure(name)), std::string(format)});
  table.columns.push_back({"reference", "reference"});

  std::vector<std::size_t> order(cases.rows);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](std::size_t row) {
    return std::tuple(text(cases, "scene", row), method_of(cases, row),
                      mesh_of(cases, row), number(cases, "nu", row),
                      number(cases, "deformation", row), text(cases, "key", row));
  });
  const auto further = further_settings(cases);
  if (!further.empty()) table.columns.push_back({"further", "further settings"});
  for (const std::size_t row : order) {
    table.rows.push_back(row_of(cases, row));
    if (further.empty()) continue;
    const auto words = further.find(row);
    table.rows.back().cells.emplace_back(words == further.end() ? std::string()
                                                                : words->second);
  }
  return table;
}

}  // namespace springcheck
