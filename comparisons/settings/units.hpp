#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace springcheck {

/// Physical quantities of settings. Plain numbers of them are in SI units.
enum class Dimension {
  none,
  length,             // m
  pressure,           // Pa
  density,            // kg/m^3
  time,               // s
  rate,               // 1/s
  angular_frequency,  // rad/s
  acceleration,       // m/s^2
  stiffness,          // N/m
  fraction,           // 1
  angle,              // rad
  deformation         // an angle in torsion, a fraction in other tests
};

/// Names of its units, the SI unit first where it has a name.
std::vector<std::string_view> units_of(Dimension dimension);

/// The unit that plain numbers are in; "-" for numbers without one.
std::string_view si_unit_of(Dimension dimension);

/// "a finite number, plain or in Pa, kPa, ..., as in '5kPa'", for messages.
std::string numbers_in_units(Dimension dimension);

/// The number that begins the text and what follows it, "10" and "kPa"; nothing where the
/// text begins with none.
struct Measurement {
  std::string number;
  std::string unit;
};
std::optional<Measurement> measurement(std::string_view text);

/// The value in the dimension's SI unit of a number with a unit of it, or without any:
/// the double nearest to the exact value, so that "35%" is .35 and "5cm" .05. Nothing for
/// a unit of another dimension.
std::optional<double> value_of(const Measurement& measured, Dimension dimension);

}  // namespace springcheck
