#pragma once

#include <functional>
#include <string>

#include "comparisons/case.hpp"

namespace springcheck {

/// A cube of cells^3 cells of 5 mm between glued plates at rest, its nodes inside off
/// their places, that is stepped through time to see how fast.
struct SteppedBody {
  std::string method;  // by its name; "naive" is NaiveSprings of mss-cf's network
  int cells;           // along each edge
  double poisson_ratio;
  double damping_ratio;
  mss::Precision precision;
  dynamics::InstructionSet instruction_set;
  int threads;
};

/// Makes one step per call. Semi-implicit Euler, half the stable step of mss-cf.
std::function<void()> stepping(const SteppedBody& body);

}  // namespace springcheck
