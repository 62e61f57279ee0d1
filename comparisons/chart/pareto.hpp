#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace springcheck {

/// What a point costs and how far it is off; it has no place on a front without both.
struct Cost {
  std::optional<double> error, seconds;
};

/// Smallest gain in accuracy that is worth more time, as a fraction of the error.
inline constexpr double worthwhile_gain = 0.01;

/// Places of the points from the fastest to the most accurate, each the fastest that is
/// more accurate than the one before by a worthwhile gain. Of equal ones the first
/// counts.
std::vector<std::size_t> pareto_front(std::span<const Cost> points);

}  // namespace springcheck
