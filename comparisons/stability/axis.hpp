#pragma once

#include <string>
#include <vector>

#include "comparisons/settings/given.hpp"
#include "comparisons/settings/run_settings.hpp"

namespace springcheck {

/// A setting with the values it takes in turn.
struct Axis {
  std::string key;
  std::vector<std::string> values{};  // as a user would write them
  bool is_range;                      // ascending numbers: one can be between two others
};

/// "KEY=FROM:TO:COUNT" or "KEY=FROM:TO:log:COUNT", see values_of_range, or "KEY=A,B,C";
/// semicolons separate values that are lists ("cells=4,4,4;6,6,6"). Numbers may end in a
/// unit. Throws InputError, naming `place`.
Axis axis_named(const std::string& place, const std::string& text);

/// What stands behind one --over: an axis with its values, or only keys, "KEY[,KEY]",
/// each over values of its own: deformation by 5 to 60 %, in torsion 15 to 180 degrees;
/// nu, dt-ratio, damping, diagonal-ratio, distortion and cell-type likewise.
std::vector<Axis> axes_named(const std::string& place, const std::string& text,
                             Test test);

/// The axis of a setting and its values.
Axis axis_of(const std::string& key, const std::vector<std::string>& values);

GivenSetting setting(const Axis& axis, const std::string& value);

/// The value in the middle of two of a range, in their unit.
std::string middle(const std::string& low, const std::string& high);

/// The number that starts the value, and the unit behind it: "" or "%".
double number_of(const std::string& value);
std::string unit_of(const std::string& value);

/// How many of the unit make one, or a radian.
double units_per_one(const std::string& unit);

}  // namespace springcheck
