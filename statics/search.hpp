#pragma once

#include "statics/systems/linear_solver.hpp"

namespace springcheck::statics {

/// The equilibrium that is searched for, and what it is searched with.
struct Search {
  bool to_limit = false;  // the last stable state of the path, not that of the full load
  LinearSolver linear_solver = LinearSolver::automatic;
  // The rest is for the state of the full load alone:
  unsigned seed = 1;  // of the way out of a saddle, and of the noise
  double noise = 0;   // in mean cell edges
};

}  // namespace springcheck::statics
