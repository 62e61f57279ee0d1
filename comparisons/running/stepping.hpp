#pragma once

#include <functional>
#include <string>

#include "comparisons/cases/case.hpp"

namespace springcheck {

/// What acts on a stepped body: glued plates above and below, or its weight on one
/// clamped end.
enum class SteppedLoad { plates, weight };

/// A block of cells of 5 mm, its nodes inside off their places, that is stepped through
/// time to see how fast.
struct SteppedBody {
  // By its name, mss-tissue of spleen, in double precision; "naive" is NaiveSprings of
  // mss-cf's network, and "mss-affine-plain" the plain loops of mss-affine:
  std::string method;
  std::array<int, 3> cells;
  SteppedLoad load;
  double poisson_ratio;
  double damping_ratio;
  mss::Precision precision;
  dynamics::InstructionSet instruction_set;
  int threads;
  double distortion = 0;  // of the nodes inside, in cell edges
};

/// What steps a body.
struct Stepping {
  std::function<void()> advance;
  double bytes;  // of what moves: its arrays and constants, without mesh and network
};

/// advance makes one step per call: semi-implicit Euler, 0.05 ms, which is less than half
/// the stable step of mss-cf up to nu = .499. The naive ones know neither plates nor
/// weight, and double precision alone.
Stepping stepping(const SteppedBody& body);

struct StepTime {
  double real;            // [s] per step, the shortest of a few measurements
  double user_over_real;  // processor time over real time: how many threads worked
};

/// Steps for about half a second.
StepTime time_of_steps(const std::function<void()>& advance);

}  // namespace springcheck
