#include "comparisons/settings/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <numbers>

namespace springcheck {
namespace {

/// A unit that is a power of ten of the SI unit.
struct Unit {
  Dimension dimension;
  std::string_view name;
  int exponent;
};

using enum Dimension;
constexpr std::array units{
    Unit{length, "m", 0},
    Unit{length, "cm", -2},
    Unit{length, "mm", -3},
    Unit{length, "um", -6},
    Unit{pressure, "Pa", 0},
    Unit{pressure, "kPa", 3},
    Unit{pressure, "MPa", 6},
    Unit{pressure, "GPa", 9},
    Unit{pressure, "N/m^2", 0},
    Unit{pressure, "N/cm^2", 4},
    Unit{pressure, "N/mm^2", 6},
    Unit{density, "kg/m^3", 0},
    Unit{density, "g/cm^3", 3},
    Unit{Dimension::time, "s", 0},
    Unit{Dimension::time, "ms", -3},
    Unit{Dimension::time, "us", -6},
    Unit{rate, "1/s", 0},
    Unit{rate, "1/ms", 3},
    Unit{rate, "%/s", -2},
    Unit{angular_frequency, "rad/s", 0},
    Unit{acceleration, "m/s^2", 0},
    Unit{acceleration, "cm/s^2", -2},
    Unit{acceleration, "mm/s^2", -3},
    Unit{stiffness, "N/m", 0},
    Unit{stiffness, "N/cm", 2},
    Unit{stiffness, "N/mm", 3},
    Unit{stiffness, "kN/m", 3},
    Unit{fraction, "%", -2},
    Unit{angle, "rad", 0},
};
constexpr std::string_view degrees = "deg";

/// The number nearest to number x 10^exponent.
template <class Number>
std::optional<Number> scaled(std::string_view number, int exponent) {
  constexpr int largest = 10'000;  // far beyond any number
  const std::size_t e = number.find_first_of("eE");
  if (e != std::string_view::npos) {
    std::string_view digits = number.substr(e + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    int own = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), own);
    if (error != std::errc{} || own < -largest || own > largest) return std::nullopt;
    exponent += own;
  }
  const std::string text = fmt::format("{}e{}", number.substr(0, e), exponent);
  Number value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// An angle in radians, computed in long double, whose rounding is far below a double's.
std::optional<double> radians(std::string_view number) {
  const std::optional<long double> value = scaled<long double>(number, 0);
  if (!value) return std::nullopt;
  return static_cast<double>(*value * std::numbers::pi_v<long double> / 180);
}

}  // namespace

std::vector<std::string_view> units_of(Dimension dimension) {
  if (dimension == deformation) return {"%", "rad", degrees};
  std::vector<std::string_view> names;
  for (const Unit& unit : units)
    if (unit.dimension == dimension) names.push_back(unit.name);
  if (dimension == angle) names.push_back(degrees);
  return names;
}

std::string_view si_unit_of(Dimension dimension) {
  for (const Unit& unit : units)
    if (unit.dimension == dimension && unit.exponent == 0) return unit.name;
  return "-";
}

std::string numbers_in_units(Dimension dimension) {
  const std::vector<std::string_view> names = units_of(dimension);
  return fmt::format("a finite number, plain or in {}, as in '{}{}'",
                     fmt::join(names, ", "), dimension == angle ? 45 : 5, names.back());
}

std::optional<Measurement> measurement(std::string_view text) {
  double value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument) return std::nullopt;
  const std::size_t length = static_cast<std::size_t>(end - text.data());
  std::string_view unit = text.substr(length);
  while (unit.starts_with(' ')) unit.remove_prefix(1);
  return Measurement{std::string(text.substr(0, length)), std::string(unit)};
}

std::optional<double> value_of(const Measurement& measured, Dimension dimension) {
  if (measured.unit.empty()) return scaled<double>(measured.number, 0);
  if (dimension == angle && measured.unit == degrees) return radians(measured.number);
  for (const Unit& unit : units)
    if (unit.dimension == dimension && unit.name == measured.unit)
      return scaled<double>(measured.number, unit.exponent);
  return std::nullopt;
}

}  // namespace springcheck
