#include "comparisons/stability/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>

#include "comparisons/names/suggestion.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/settings/value_range.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

constexpr const char* expected =
    "KEY=FROM:TO:COUNT or KEY=FROM:TO:log:COUNT with FROM < TO (above 0 for log) and "
    "COUNT from 2 to 1000, or KEY=A,B,C";

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// Whether they are numbers of the setting, in one unit, each above the one before.
bool is_ascending(const Setting& setting, const std::vector<std::string>& values) {
  if (!is_number(setting.access.type)) return false;
  std::vector<std::string_view> units = units_of(setting.dimension);
  units.emplace_back("");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto here = written_number(values[i]);
    if (!here || std::ranges::count(units, here->unit) == 0) return false;
    if (i == 0) continue;
    const auto before = written_number(values[i - 1]);
    if (before->unit != here->unit || !(before->value < here->value)) return false;
  }
  return true;
}

/// The values of a setting that is named without any.
std::string usual_values(const std::string& key, Test test) {
  if (key == "deformation" && entry_of(test).turns) return "15deg:180deg:12";
  const Setting* setting = find_setting(key);
  return setting == nullptr ? "" : std::string(setting->usual_axis);
}

/// Settings along which a map may go.
std::vector<std::string_view> axis_keys() {
  std::vector<std::string_view> keys;
  for (const Setting& setting : all_settings())
    if (setting.standing == Standing::everywhere) keys.push_back(setting.key);
  return keys;
}

}  // namespace

std::vector<Axis> axes_named(const std::string& place, const std::string& text,
                             Test test) {
  if (text.find('=') != std::string::npos) return {axis_named(place, text)};
  std::vector<Axis> axes;
  for (const std::string& key : split(text, ','))
    axes.push_back(axis_named(place, key + "=" + usual_values(key, test)));
  return axes;
}

Axis axis_named(const std::string& place, const std::string& text) {
  const auto refuse = [&]() { throw InputError(place, "", expected, "'" + text + "'"); };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse();
  Axis axis{.key = text.substr(0, equals), .is_range = false};
  if (const auto keys = axis_keys(); std::ranges::count(keys, axis.key) == 0)
    refuse_name(place, "setting of a run", axis.key, keys);
  const std::string values = text.substr(equals + 1);
  if (values.empty()) refuse();
  axis.values = values.find(':') != std::string::npos
                    ? values_of_range(values)
                    : split(values, values.find(';') == std::string::npos ? ',' : ';');
  if (axis.values.empty() || std::ranges::count(axis.values, "") > 0) refuse();
  return axis_of(axis.key, axis.values);
}

Axis axis_of(const std::string& key, const std::vector<std::string>& values) {
  const Setting* setting = find_setting(key);
  return {.key = key,
          .values = values,
          .is_range = setting != nullptr && !setting->counts && values.size() > 1 &&
                      is_ascending(*setting, values)};
}

GivenSetting setting(const Axis& axis, const std::string& value) {
  return {axis.key, Given::from_text("--over " + axis.key, value)};
}

std::string middle(const std::string& low, const std::string& high) {
  const WrittenNumber a = written_number(low).value(), b = written_number(high).value();
  return text_of({(a.value + b.value) / 2, a.unit});
}

double number_of(const std::string& value) {
  return written_number(value).value().value;
}

std::string unit_of(const std::string& value) {
  return written_number(value).value().unit;
}

double units_per_one(const std::string& unit) {
  return unit == "%" ? 100 : unit == "deg" ? 180 / std::numbers::pi : 1;
}

}  // namespace springcheck
