#pragma once

#include <optional>

#include "mss/network.hpp"

namespace springcheck::mss {

/// The thesis's protocol: plates at constant velocity, semi-implicit Euler.
struct DynamicsSettings {
  double duration;                  // [s] over which the load grows from 0 to 1
  std::optional<double> time_step;  // [s]; none: 0.9 of the stability limit
  bool force_time_step;             // run even above the stability limit
  double damping_ratio;             // zeta of the springs' dashpots
};

/// Runs the dynamics and returns the state at the end of `duration`:
///
///     v += dt/m f(x, v)     x += dt v
///
/// with f of springs, volume correction, dashpots, gravity and tractions (these two
/// growing with the load fraction).
/// The step is shortened so that a whole number of them fills the duration. A step above
/// largest_stable_step is refused unless forced, and so is a step left open where that is
/// infinite though nodes are free; positions that are no longer finite,
/// or a hundred body sizes away, end the run as diverged with the step's number.
Solution run_dynamics(const Mesh& mesh, const Scene& scene, const Network& network,
                      const DynamicsSettings& settings);

}  // namespace springcheck::mss
