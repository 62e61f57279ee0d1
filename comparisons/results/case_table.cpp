#include "comparisons/results/case_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <string_view>

#include "comparisons/measures/measure_list.hpp"
#include "comparisons/names/suggestion.hpp"
#include "comparisons/results/layout.hpp"
#include "comparisons/settings/setting.hpp"

namespace springcheck {
namespace {

using Texts = std::vector<std::string>;
using Numbers = std::vector<double>;

/// A name of the file's table of cases.
struct Name {
  std::string_view name, unit;
  enum Kind { which, setting, measure, how } kind;
};

/// Every name, in the order of the columns: which case, settings, measures, how it ended.
std::vector<Name> all_names() {
  constexpr std::string_view before_settings[] = {"key", "identity", "scene", "family",
                                                  "mesh"};
  std::vector<Name> names, after;
  for (const Described& column : case_columns()) {
    const bool is_first = std::ranges::count(before_settings, column.name) > 0;
    (is_first ? names : after)
        .push_back({column.name, column.unit, is_first ? Name::which : Name::how});
  }
  for (const Setting& setting : all_settings())
    if (setting.access.told != nullptr) {
      const std::string_view unit = si_unit_of(setting.dimension);
      names.push_back({setting.key, unit == "-" ? "" : unit, Name::setting});
    }
  for (const Measure& measure : measure_list)
    names.push_back({measure.name, measure.unit, Name::measure});
  names.insert(names.end(), after.begin(), after.end());
  names.push_back({"other_revision", "", Name::how});
  return names;
}

std::string component_name(std::string_view name, std::string_view component) {
  return std::string(name) + "." + std::string(component);
}

/// The unit of a name's columns. Where bodies are turned, the deformation is an angle.
std::string unit_of(const Name& name, const Columns& cases) {
  const auto tests = cases.texts.find("test");
  if (name.name != "deformation" || tests == cases.texts.end())
    return std::string(name.unit);
  const auto turning = std::ranges::count_if(tests->second, [](const std::string& text) {
    const auto* test = find_value<Test>(text);
    return test != nullptr && test->turns;
  });
  if (turning == 0) return "";
  return turning == std::ssize(tests->second) ? "rad" : "1 or rad";
}

/// The columns of one name, as many as it has components; none where no case has it.
std::vector<CaseColumn> columns_of(const Columns& cases, const Name& name) {
  const std::string key(name.name), unit = unit_of(name, cases);
  if (const auto found = cases.texts.find(key); found != cases.texts.end())
    return {{key, unit, found->second}};
  const auto found = cases.numbers.find(key);
  if (found == cases.numbers.end()) return {};
  const auto& [width, values] = found->second;
  if (width == 1) return {{key, unit, values}};
  const auto names = component_names(width);
  std::vector<CaseColumn> columns;
  for (std::size_t i = 0; i < width; ++i) {
    Numbers component;
    for (std::size_t row = 0; row < cases.rows; ++row)
      component.push_back(values[row * width + i]);
    columns.push_back({component_name(name.name, names.empty() ? std::to_string(i + 1)
                                                               : std::string(names[i])),
                       unit, std::move(component)});
  }
  return columns;
}

bool is_empty(const CaseColumn& column) {
  if (const auto* texts = std::get_if<Texts>(&column.values))
    return std::ranges::all_of(*texts, &std::string::empty);
  return std::ranges::all_of(std::get<Numbers>(column.values),
                             [](double x) { return std::isnan(x); });
}

/// Whether the values differ between rows that have them, or only some rows of one test,
/// method and solver have one: other methods and solvers do not read it, which tells them
/// apart already.
bool differs(const Columns& cases, const std::string& key,
             const std::vector<std::size_t>& rows) {
  std::set<std::string> values;
  std::map<std::array<std::string, 3>, std::set<bool>> is_there;
  for (const std::size_t row : rows) {
    const std::string value = value_at(cases, key, row);
    if (!value.empty()) values.insert(value);
    is_there[{value_at(cases, "test", row), value_at(cases, "method", row),
              value_at(cases, "solver", row)}]
        .insert(!value.empty());
  }
  return values.size() > 1 || std::ranges::any_of(is_there, [](const auto& of_one) {
           return of_one.second.size() > 1;
         });
}

/// A column without values, with the unit of its name, which has no value in any case.
CaseColumn empty_column(const std::string& name, const Name& of, std::size_t rows) {
  const Setting* setting = find_setting(of.name);
  if (setting != nullptr && !holds_numbers(setting->access.type))
    return {name, std::string(of.unit), Texts(rows)};
  return {name, std::string(of.unit),
          Numbers(rows, std::numeric_limits<double>::quiet_NaN())};
}

std::vector<CaseColumn> chosen_columns(const Columns& cases, const std::string& chosen) {
  const std::vector<Name> all = all_names();
  const std::string name = chosen.substr(0, chosen.find('.'));
  const auto found = std::ranges::find(all, name, &Name::name);
  if (found == all.end()) {
    std::vector<std::string_view> names;
    for (const Name& one : all) names.push_back(one.name);
    refuse_name("--columns", "column", chosen, names);
  }
  std::vector<CaseColumn> columns = columns_of(cases, *found);
  if (columns.empty()) return {empty_column(chosen, *found, cases.rows)};
  if (chosen == name) return columns;
  const auto component = std::ranges::find(columns, chosen, &CaseColumn::name);
  if (component != columns.end()) return {*component};
  std::vector<std::string_view> names{name};
  if (columns.size() > 1)
    for (const CaseColumn& column : columns) names.push_back(column.name);
  refuse_name("--columns", "column", chosen, names);
}

}  // namespace

std::string value_at(const Columns& cases, const std::string& key, std::size_t row) {
  if (const auto texts = cases.texts.find(key); texts != cases.texts.end())
    return texts->second[row];
  const auto found = cases.numbers.find(key);
  if (found == cases.numbers.end()) return "";
  const auto& [width, all] = found->second;
  const std::span numbers(all.data() + row * width, width);
  if (std::ranges::all_of(numbers, [](double x) { return std::isnan(x); })) return "";
  return fmt::format("{}", fmt::join(numbers, "/"));
}

std::vector<std::string> differing_settings(const Columns& cases,
                                            const std::vector<std::size_t>& rows) {
  std::vector<std::string> keys;
  for (const Setting& setting : all_settings()) {
    const std::string key(setting.key);
    if (setting.access.told != nullptr && !rows.empty() && differs(cases, key, rows))
      keys.push_back(key);
  }
  return keys;
}

std::vector<CaseColumn> case_table(const Columns& cases,
                                   const std::vector<std::string>& chosen) {
  std::vector<CaseColumn> table;
  const auto add = [&](std::vector<CaseColumn> columns) {
    for (CaseColumn& column : columns)
      if (!std::ranges::count(table, column.name, &CaseColumn::name))
        table.push_back(std::move(column));
  };
  for (const std::string& name : chosen) add(chosen_columns(cases, name));
  if (!chosen.empty()) return table;

  std::vector<std::size_t> rows(cases.rows);
  std::iota(rows.begin(), rows.end(), 0);
  const std::vector<std::string> differing = differing_settings(cases, rows);
  const auto is_wanted = [&](const Name& name) {
    if (name.kind == Name::setting)
      return name.name == "method" || std::ranges::count(differing, name.name) > 0;
    return name.name != "reference_settings";
  };
  for (const Name& name : all_names())
    if (is_wanted(name)) {
      std::vector<CaseColumn> columns = columns_of(cases, name);
      std::erase_if(columns, is_empty);
      add(std::move(columns));
    }
  return table;
}

}  // namespace springcheck
