#include "comparisons/gates/selection.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ranges>
#include <span>

#include "comparisons/names/suggestion.hpp"
#include "comparisons/settings/setting.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck::gates {
namespace {

using Scalar = Given::Scalar;

/// Columns of settings, whether or not a case of the file has them.
std::vector<std::string> settings() {
  std::vector<std::string> names{"scene", "key", "status", "mesh", "reference"};
  for (const Setting& setting : all_settings())
    if (setting.access.told != nullptr) names.emplace_back(setting.key);
  return names;
}

void check_known(const Columns& cases, const Condition& condition) {
  const auto known = settings();
  if (cases.texts.contains(condition.column) ||
      cases.numbers.contains(condition.column) ||
      std::ranges::count(known, condition.column) > 0)
    return;
  refuse_name(condition.place, "column", condition.column, {known.begin(), known.end()});
}

/// A number as a column of numbers holds it.
double number_of(const Condition& condition, const Scalar& value) {
  const Given given(condition.place, value);
  const Setting* setting = find_setting(condition.column);
  if (number_in(value) || setting == nullptr || setting->dimension == Dimension::none)
    return given.number("a number, as cases have it");
  if (setting->dimension != Dimension::deformation) return given.in(setting->dimension);
  const auto* text = std::get_if<std::string>(&value);  // of torsion, or of another test
  const bool is_angle = text != nullptr && !text->ends_with('%');
  return given.in(is_angle ? Dimension::angle : Dimension::fraction);
}

/// A text as a column of texts holds it: of a setting that may be written in several
/// ways, as cases tell it.
std::string text_in(const Condition& condition, const Scalar& value) {
  const Setting* setting = find_setting(condition.column);
  if (setting != nullptr && setting->access.type.kind == ValueType::Kind::table) {
    RunSettings run{};
    setting->access.read(run, Given(condition.place, value));
    const nlohmann::json told = setting->access.told(run.common);
    return told.is_string() ? told.get<std::string>() : std::string();
  }
  const auto* text = std::get_if<std::string>(&value);
  return text != nullptr ? *text : described(value);
}

bool is_absent(const Columns& cases, const std::string& column, std::size_t row) {
  if (const auto texts = cases.texts.find(column); texts != cases.texts.end())
    return texts->second[row].empty();
  const auto numbers = cases.numbers.find(column);
  return numbers == cases.numbers.end() ||
         std::isnan(numbers->second.values[row * numbers->second.width]);
}

bool number_matches(const Condition& condition, const NumberColumn& column,
                    std::size_t row) {
  const auto is_value = [&](const std::vector<Scalar>& value) {
    if (value.size() != column.width)
      throw InputError(
          condition.place, "",
          column.width == 1
              ? "a number or a list of them"
              : fmt::format("{} numbers, or a list of such lists", column.width),
          text_of(condition));
    for (std::size_t i = 0; i < column.width; ++i)
      if (!same_number(column.values[row * column.width + i],
                       number_of(condition, value[i])))
        return false;
    return true;
  };
  return std::ranges::any_of(values_of(condition, column.width), is_value);
}

bool matches(const Columns& cases, const Condition& condition, std::size_t row) {
  if (is_absent(cases, condition.column, row)) return condition.absent == Absent::passes;
  if (const auto numbers = cases.numbers.find(condition.column);
      numbers != cases.numbers.end())
    return number_matches(condition, numbers->second, row);
  const std::string& cell = cases.texts.at(condition.column)[row];
  return std::ranges::any_of(values_of(condition, 1), [&](const auto& value) {
    return value.size() == 1 && text_in(condition, value[0]) == cell;
  });
}

}  // namespace

Selection narrowed(const Selection& selection, const Selection& narrower) {
  Selection all = narrower;
  for (const Condition& condition : selection)
    if (!std::ranges::count(narrower, condition.column, &Condition::column))
      all.push_back(condition);
  return all;
}

std::vector<std::vector<Scalar>> values_of(const Condition& condition,
                                           std::size_t width) {
  if (!condition.is_flat_list || width > 1) return condition.values;
  std::vector<std::vector<Scalar>> values;
  for (const Scalar& value : condition.values.front()) values.push_back({value});
  return values;
}

std::string text_of(const Condition& condition) {
  const auto text_of_value = [&](const std::vector<Scalar>& value) {
    const auto numbers =
        fmt::format("{}", fmt::join(value | std::views::transform(described), ", "));
    const bool is_list = value.size() != 1 || condition.is_flat_list;
    return is_list ? "[" + numbers + "]" : numbers;
  };
  return fmt::format(
      "{} = {}", condition.column,
      fmt::join(condition.values | std::views::transform(text_of_value), " or "));
}

std::string text_of(const Selection& selection) {
  const auto text = [](const Condition& condition) { return text_of(condition); };
  return fmt::format("{}", fmt::join(selection | std::views::transform(text), ", "));
}

std::vector<std::size_t> matching(const Columns& cases, const Selection& selection) {
  for (const Condition& condition : selection) check_known(cases, condition);
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < cases.rows; ++row)
    if (std::ranges::all_of(selection, [&](const Condition& condition) {
          return matches(cases, condition, row);
        }))
      rows.push_back(row);
  return rows;
}

bool same_number(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
}

std::string cell_text(const Columns& cases, const std::string& column, std::size_t row) {
  if (const auto texts = cases.texts.find(column); texts != cases.texts.end())
    return texts->second[row];
  const auto numbers = cases.numbers.find(column);
  if (numbers == cases.numbers.end()) return "";
  const std::size_t width = numbers->second.width;
  const auto is_there = [](double number) { return !std::isnan(number); };
  return fmt::format(
      "{:.12g}", fmt::join(std::span(numbers->second.values).subspan(row * width, width) |
                               std::views::filter(is_there),
                           ","));
}

std::set<std::string> differences(const Columns& cases,
                                  const std::vector<std::size_t>& rows) {
  std::set<std::string> columns;
  for (const std::string& column : settings())
    for (const std::size_t row : rows)
      if (cell_text(cases, column, row) != cell_text(cases, column, rows[0]))
        columns.insert(column);
  for (const char* result : {"mesh", "status"}) columns.erase(result);
  if (columns.size() > 1) columns.erase("key");  // which follows from the others
  return columns;
}

std::string differences_text(const Columns& cases, const std::vector<std::size_t>& rows) {
  constexpr std::size_t most = 4;  // values of a column
  std::vector<std::string> columns;
  for (const std::string& column : differences(cases, rows)) {
    std::vector<std::string> values;
    for (const std::size_t row : rows) {
      const std::string text = cell_text(cases, column, row);
      const std::string value = text.empty() ? "none" : text;
      if (std::ranges::count(values, value) == 0) values.push_back(value);
    }
    if (values.size() > most) {
      values.resize(most);
      values.emplace_back("...");
    }
    columns.push_back(fmt::format("{} ({})", column, fmt::join(values, " or ")));
  }
  return fmt::format("{}", fmt::join(columns, ", "));
}

/// The one of the values that a text was meant to be, in a message.
std::string meant_by(const Condition& condition, const std::set<std::string>& values) {
  if (condition.values.size() != 1 || condition.values[0].size() != 1) return {};
  const auto* text = std::get_if<std::string>(&condition.values[0][0]);
  if (text == nullptr) return {};
  const std::string_view meant = nearest(*text, {values.begin(), values.end()});
  return meant.empty() ? "" : fmt::format("did you mean '{}'? ", meant);
}

std::string why_not_one(const Columns& cases, const Selection& selection,
                        const std::vector<std::size_t>& rows) {
  if (rows.size() > 1)
    return fmt::format("{} cases match {}; they differ in {}", rows.size(),
                       text_of(selection), differences_text(cases, rows));
  std::string text = "no case matches " + text_of(selection);
  for (std::size_t i = 0; i < selection.size(); ++i) {
    Selection others = selection;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    std::set<std::string> values;
    for (const std::size_t row : matching(cases, others))
      values.insert(cell_text(cases, selection[i].column, row));
    if (!values.empty())
      return text + "; " + meant_by(selection[i], values) +
             fmt::format("the others have {} = {}", selection[i].column,
                         fmt::join(values, " or "));
  }
  return text;
}

}  // namespace springcheck::gates
