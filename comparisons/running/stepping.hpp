#pragma once

#include <functional>
#include <string>

#include "comparisons/cases/case.hpp"

namespace springcheck {

/// What acts on a stepped body: glued plates above and below, or its weight on one
/// clamped end.
enum class SteppedLoad { plates, weight };

/// What computes the forces of steps: the method's kernel; its plain loops, where a
/// kernel takes their place; or, of springs, NaiveSprings, which know neither plates nor
/// weight.
enum class Loops { kernel, plain, naive };

/// A block of cells of 5 mm, its nodes inside off their places, that is stepped through
/// time to see how fast.
struct SteppedBody {
  std::string method;  // by its name; tissue is of spleen
  std::array<int, 3> cells;
  SteppedLoad load;
  double poisson_ratio;
  double damping_ratio;
  mss::Precision precision;
  dynamics::InstructionSet instruction_set;
  int threads;
  double distortion = 0;  // of the nodes inside, in cell edges
  Loops loops = Loops::kernel;
};

/// What steps a body.
struct Stepping {
  std::function<void()> advance;
  double bytes;  // of what moves: its arrays and constants, without mesh and network
};

/// advance makes one step per call: semi-implicit Euler, 0.05 ms, which is less than half
/// the stable step of mss-cf up to nu = .499. Plain and naive loops have double precision
/// alone.
Stepping stepping(const SteppedBody& body);

struct StepTime {
  double real;            // [s] per step, the shortest of a few measurements
  double user_over_real;  // processor time over real time: how many threads worked
};

/// Steps for about half a second.
StepTime time_of_steps(const std::function<void()>& advance);

}  // namespace springcheck
