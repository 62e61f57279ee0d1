#include "comparisons/stability/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>

#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

constexpr const char* expected =
    "KEY=FROM:TO:COUNT with FROM < TO and COUNT from 2 to 1000, or KEY=A,B,C";

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

struct Number {
  double value;
  std::string unit;  // what follows it
};

std::optional<Number> number(const std::string& text) {
  Number found{};
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), found.value);
  if (error != std::errc{} || !std::isfinite(found.value)) return std::nullopt;
  found.unit = std::string(end, text.data() + text.size());
  if (!found.unit.empty() && found.unit != "%" && found.unit != "deg")
    return std::nullopt;
  return found;
}

/// 0.15, not 0.15000000000000002.
std::string text_of(const Number& number) {
  return fmt::format("{:.12g}{}", number.value, number.unit);
}

bool is_ascending(const std::vector<std::string>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto here = number(values[i]);
    if (!here) return false;
    if (i == 0) continue;
    const auto before = number(values[i - 1]);
    if (before->unit != here->unit || !(before->value < here->value)) return false;
  }
  return true;
}

/// The values of a setting that is named without any.
std::optional<std::string> usual_values(const std::string& key, Test test) {
  if (key == "deformation")
    return test == Test::torsion ? "15deg:180deg:12" : "5%:60%:12";
  if (key == "nu") return "0,0.05,0.1,0.15,0.2,0.25,0.3,0.35,0.4,0.45,0.49,0.499";
  if (key == "dt-ratio") return "0.8:1.2:9";
  if (key == "damping") return "0,0.01,0.02,0.05,0.1,0.2,0.5,1";
  if (key == "diagonal-ratio") return "0.01,0.03,0.1,0.3,1,3,10,30,100";
  if (key == "distortion") return "0:0.3:7";
  if (key == "cell-type") return "hexahedron,tetrahedron,prism,pyramid,mixed";
  return std::nullopt;
}

}  // namespace

std::vector<Axis> axes_named(const std::string& place, const std::string& text,
                             Test test) {
  if (text.find('=') != std::string::npos) return {axis_named(place, text)};
  std::vector<Axis> axes;
  for (const std::string& key : split(text, ','))
    axes.push_back(
        axis_named(place, key + "=" + usual_values(key, test).value_or(std::string())));
  return axes;
}

Axis axis_named(const std::string& place, const std::string& text) {
  const auto refuse = [&]() { throw InputError(place, "", expected, "'" + text + "'"); };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse();
  Axis axis{.key = text.substr(0, equals), .values = {}, .is_range = false};
  if (std::ranges::count(option_keys(), axis.key, &SettingKey::name) == 0 ||
      axis.key == "method" || axis.key == "reference")
    throw InputError(
        place, "",
        "one of the options of run but method and reference: nu, deformation, dt-ratio, "
        "damping, diagonal-ratio, distortion, cell-type, cells, noise, seed and others",
        "'" + axis.key + "'");
  const std::string values = text.substr(equals + 1);
  if (values.empty()) refuse();
  const std::vector<std::string> range = split(values, ':');
  if (range.size() != 1 && range.size() != 3) refuse();
  if (range.size() == 3) {
    const auto from = number(range[0]), to = number(range[1]);
    int count = 0;
    const std::string& digits = range[2];
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), count);
    if (!from || !to || from->unit != to->unit || !(from->value < to->value) ||
        error != std::errc{} || end != digits.data() + digits.size() || count < 2 ||
        count > 1000)
      refuse();
    for (int i = 0; i < count; ++i) {
      const double part = static_cast<double>(i) / (count - 1);
      axis.values.push_back(
          text_of({(1 - part) * from->value + part * to->value, from->unit}));
    }
  } else {
    axis.values = split(values, values.find(';') == std::string::npos ? ',' : ';');
  }
  if (axis.values.empty() || std::ranges::count(axis.values, "") > 0) refuse();
  return axis_of(axis.key, axis.values);
}

Axis axis_of(const std::string& key, const std::vector<std::string>& values) {
  const bool counts = key == "seed" || key == "history";  // nothing lies between two
  return {.key = key,
          .values = values,
          .is_range = !counts && values.size() > 1 && is_ascending(values)};
}

GivenSetting setting(const Axis& axis, const std::string& value) {
  return {axis.key, Given::from_text("--over " + axis.key, value)};
}

std::string middle(const std::string& low, const std::string& high) {
  const Number a = number(low).value(), b = number(high).value();
  return text_of({(a.value + b.value) / 2, a.unit});
}

double number_of(const std::string& value) {
  return number(value).value().value;
}

std::string unit_of(const std::string& value) {
  return number(value).value().unit;
}

double units_per_one(const std::string& unit) {
  return unit == "%" ? 100 : unit == "deg" ? 180 / std::numbers::pi : 1;
}

}  // namespace springcheck
