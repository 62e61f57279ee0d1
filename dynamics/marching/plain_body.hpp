#pragma once

#include "dynamics/marching/march.hpp"
#include "dynamics/precision.hpp"
#include "meshing/basics/stopwatch.hpp"

namespace springcheck::dynamics {

/// A body with its forces by plain loops, whatever moves it, under the scene's loads.
struct PlainBody {
  const Mesh& mesh;
  const Scene& scene;
  std::span<const double> masses;  // [kg] of each node
  PlainForces forces;
  double damping_ratio;  // 0: without dashpots
  std::string undamped;  // what leaves motions undamped; MarchedBody
  LeverArms lever_arms = LeverArms::deformed;
};

/// Marches the body by a motion of that precision, by whose own forces stable steps are
/// found, about rest and in the states on the way; see march of a MarchedBody.
Solution march(const PlainBody& body, Motion& motion, Precision precision,
               const Protocol& protocol, const Observers& observers,
               const Stopwatch& setup);

/// Largest stable step about rest, by the plain loops.
double largest_stable_step(const PlainBody& body, Integrator integrator);

}  // namespace springcheck::dynamics
