#pragma once

#include <vector>

namespace springcheck::dynamics {

/// The load through time: straight lines from rest at time 0 through these points, times
/// ascending.
struct LoadPoint {
  double time;      // [s]
  double fraction;  // of the full load
};
using LoadPath = std::vector<LoadPoint>;

/// In proportion to the time, to the full load at the end.
LoadPath ramp(double duration);

/// The fraction at a time from 0 to that of the last point.
double load_fraction(const LoadPath& path, double time);

/// Straight pieces that ended by a time, and the part of the present one that has passed.
double pieces_passed(const LoadPath& path, double time);

}  // namespace springcheck::dynamics
