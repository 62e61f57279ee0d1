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

/// The load that grows in proportion to the time and reaches the full load at the end.
LoadPath ramp(double duration);

/// sin(omega t) over so many cycles, a last one in part among them, in straight pieces of
/// a cycle/64 or less: their first harmonic is 1 - (pi/64)^2/3, .08 % less than 1. Each
/// half cycle ends without a load, exactly.
LoadPath oscillation(double angular_frequency, double cycles);

/// The fraction at a time from 0 to that of the last point.
double load_fraction(const LoadPath& path, double time);

/// The places where a path turns, its last point among them: what rises or falls all the
/// way is one piece.
LoadPath turning_points(const LoadPath& path);

/// The number of straight pieces that have ended by a time, plus the part of the present
/// one that has passed.
double pieces_passed(const LoadPath& path, double time);

}  // namespace springcheck::dynamics
