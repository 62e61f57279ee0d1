#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "comparisons/gates/selection.hpp"
#include "comparisons/studies/study.hpp"

namespace springcheck::gates {

/// Half width of a band about a value: the larger of `absolute` and `relative` times the
/// value's magnitude.
struct Width {
  double absolute = 0, relative = 0;
};

double half_width(const Width& width, double about);

/// The numbers from `low` to `high`, both included; a side that is empty is open.
struct Range {
  std::optional<double> low, high{};
};

// What the measure is compared with, one of these:

/// The measure is compared with nothing: the case's status alone counts.
struct StatusAlone {};

/// A value that stands in the gate file.
struct Stored {
  double value;
  Width width;
  std::size_t line, column;  // of the value, from 1
};

/// The measure of another case, or another measure of the same.
struct Against {
  Selection where;
  std::string measure;
  Width width;
};

/// The measure of the case over that of another case.
struct Ratio {
  Selection where;
  std::string measure;
  Range range;
};

/// The values of several cases, sorted by the column `along`.
enum class Direction { increasing, decreasing };
}  // namespace springcheck::gates

namespace springcheck {
template <>
inline constexpr std::array value_names<gates::Direction>{
    Named{gates::Direction::increasing, "increasing"},
    Named{gates::Direction::decreasing, "decreasing"}};
}  // namespace springcheck

namespace springcheck::gates {
struct Monotonic {
  Direction direction;
  std::string along;
};

/// Observed order of convergence of the three finest grids.
struct Order {
  Range range;
};

using Comparison =
    std::variant<StatusAlone, Stored, Range, Against, Ratio, Monotonic, Order>;

/// Whether the figures of a gate may be blessed: those of other people are fixed.
enum class Blessing { allowed, fixed };

/// One condition on the results of a file.
struct Gate {
  std::string name, reason, place;  // place: "gates.toml:4:1"
  Selection where;
  std::string measure;         // "force.z"; empty: the status alone
  std::vector<Status> expect;  // what its cases' status may be
  Comparison comparison{};
  Blessing blessing;
};

}  // namespace springcheck::gates
