#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "dynamics/integrators.hpp"
#include "dynamics/marching/load_path.hpp"
#include "dynamics/marching/stable_step.hpp"
#include "dynamics/motion.hpp"
#include "meshing/basics/stopwatch.hpp"

namespace springcheck::dynamics {

/// What is marched through time, from rest: the supports move and the loads grow along a
/// path.
struct Protocol {
  Integrator integrator;
  double duration;                  // [s], to the last point of the load
  std::optional<double> time_step;  // [s]; none: step_ratio of the stability limit
  double step_ratio = 0.9;          // above 1 it is run all the same
  bool force_time_step;             // run even above the stability limit
  LoadPath load{};                  // empty: ramp(duration)
};

/// A step that was found to be above the stability limit.
struct Excess {
  int step;      // after so many steps
  double dt;     // [s] there
  double limit;  // [s] there
};

/// The state of a march, enough to go on from it bit for bit.
struct Checkpoint {
  State state;
  int step = 0;                    // steps made
  double time = 0;                 // [s]
  double dt = 0;                   // [s] of the steps from here on
  double last_dt = 0;              // [s] of the step made last; 0 before the first
  int steps_left = 0;              // of dt
  double limit = 0;                // [s] stability limit looked at last
  std::vector<double> stiffest{};  // StableStep::mode of that look
  int look_evaluations = 0;        // of forces, by all looks
  std::optional<Excess> excess{};  // the first, where there was one
};

/// A moment of the march as observers see it. Vectors hold one entry per node.
struct Moment {
  double time;  // [s]
  double load_fraction;
  int step;
  std::vector<Vector3> displacements{};  // [m]
  std::vector<Vector3> reactions;        // [N], see Solution
  LeverArms lever_arms;                  // of the reactions
  double kinetic_energy;                 // [J]
  double strain_energy;                  // [J]
};

/// The functions that follow a march. Empty ones are not called.
struct Observers {
  // The number of moments, at equal distances in time, on each straight piece of the
  // load, its end among them:
  int samples = 0;
  std::function<void(const Moment&)> sample{};
  std::function<void(const Checkpoint&)> checkpoint{};
  double seconds_between_checkpoints = 60;            // of real time
  std::function<void(const Checkpoint&)> progress{};  // now and then
  std::optional<Checkpoint> from{};                   // where to go on; none: from rest
};

/// The body's forces by plain loops in double precision, whatever moves it.
struct PlainForces {
  // Internal forces [N], dashpots included:
  ForcesAt internal;
  std::function<double(std::span<const Vector3> displacements)> strain_energy;  // [J]
};

/// What march needs of the body, which bears the scene's loads (load_forces).
struct MarchedBody {
  const Mesh& mesh;
  const Scene& scene;
  std::span<const double> masses;  // [kg] of each node
  PlainForces forces;
  // The largest stable step in a state (at rest where none is given), from what was found
  // in a state near it; see largest_stable_step. It leaves the motion in that state:
  std::function<StableStep(const std::optional<State>& state, const StableStep* near)>
      stable_step;
  std::string step_setters;  // what sets the limit, for messages: "nu = 0.4, ..."
  std::string undamped;      // what leaves motions undamped where the limit is 0
  LeverArms lever_arms = LeverArms::deformed;  // of the reactions
};

/// Marches to the end of the protocol and returns the state there.
///
/// The step is shortened so that a whole number of them fills the time left. One that the
/// user set and that is above the limit at rest is refused unless forced, and so is an
/// open one where the limit is infinite though nodes are free, or zero.
///
/// The limit is looked at again, in the body's present state, every 1000 steps and 40
/// times on each way that the load rises, falls or rests. An open step follows it. The
/// log and the solution's reason tell of any step that is found above it.
///
/// The march ends as diverged, with the step by which it was seen, within 100 steps where
/// positions are no longer finite or a hundred body sizes away; and where a step that was
/// found above the limit has made a motion that turns round in every step the larger part
/// of the kinetic energy (see alternation): of large amplitude it is held by what is not
/// linear, and need not leave all bounds. The solution's set-up began with `setup`.
Solution march(const MarchedBody& body, Motion& motion, const Protocol& protocol,
               const Observers& observers, const Stopwatch& setup = {});

}  // namespace springcheck::dynamics
