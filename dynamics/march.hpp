#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "dynamics/integrators.hpp"
#include "dynamics/motion.hpp"

namespace springcheck::dynamics {

/// What is marched through time: the supports move and the loads grow in proportion to
/// the time, from rest to the full load at the end.
struct Protocol {
  Integrator integrator;
  double duration;                  // [s]
  std::optional<double> time_step;  // [s]; none: .9 of the stability limit
  bool force_time_step;             // run even above the stability limit
};

/// Where a march is: enough to go on to the bit.
struct Checkpoint {
  State state;
  int step = 0;        // steps made
  double time = 0;     // [s]
  double dt = 0;       // [s] of the steps from here on
  double last_dt = 0;  // [s] of the step made last; 0 before the first
  int steps_left = 0;  // of dt
  double limit = 0;    // [s] stability limit looked at last
};

/// A moment of the march as observers see it. Vectors hold one entry per node.
struct Moment {
  double time;  // [s]
  double load_fraction;
  int step;
  std::vector<Vector3> displacements;  // [m]
  std::vector<Vector3> reactions;      // [N], see Solution
  double kinetic_energy;               // [J]
  double strain_energy;                // [J]
};

/// Who follows a march. Empty functions are not called.
struct Observers {
  int samples = 0;  // moments at equal distances in time, the end among them
  std::function<void(const Moment&)> sample{};
  std::function<void(const Checkpoint&)> checkpoint{};
  double seconds_between_checkpoints = 60;            // of real time
  std::function<void(const Checkpoint&)> progress{};  // now and then
  std::optional<Checkpoint> from{};                   // where to go on; none: from rest
};

/// The body's forces by plain loops in double precision, whatever moves it.
struct PlainForces {
  // Internal forces [N], dashpots included:
  std::function<void(const State& state, std::span<Vector3> forces)> internal;
  std::function<double(std::span<const Vector3> displacements)> strain_energy;  // [J]
};

/// What march needs of the body. Lists hold one entry per node.
struct MarchedBody {
  const Mesh& mesh;
  const Scene& scene;
  std::span<const double> masses;  // [kg]
  std::span<const Vector3> load;   // [N] at the full load
  PlainForces forces;
  // Largest stable step in a state [s]; at rest where there is none. Leaves the motion in
  // that state:
  std::function<double(const std::optional<State>& state)> stable_step;
  std::string step_setters;  // what sets the limit, for messages: "nu = 0.4, ..."
};

/// Marches to the end of the protocol and returns the state there.
///
/// The step is shortened so that a whole number of them fills the time left. One that the
/// user set and that is above the limit at rest is refused unless forced, and so is an
/// open one where the limit is infinite though nodes are free, or zero. An open step
/// follows the limit: every 1000 steps it is looked at again where the body then is.
/// Positions that are no longer finite, or a hundred body sizes away, end the march as
/// diverged with the step by which it was seen, within 100 steps.
Solution march(const MarchedBody& body, Motion& motion, const Protocol& protocol,
               const Observers& observers);

}  // namespace springcheck::dynamics
