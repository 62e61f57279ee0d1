#pragma once

#include <optional>
#include <vector>

#include "dynamics/integrators.hpp"
#include "dynamics/marching/small_motions.hpp"
#include "dynamics/motion.hpp"
#include "dynamics/precision.hpp"

namespace springcheck::dynamics {

/// What a search finds, and leaves to the next one.
struct StableStep {
  double limit;  // [s]
  // The motion that sets it, sqrt(m) u of each component, held ones included; empty where
  // it is not known:
  std::vector<double> mode{};
  int force_evaluations = 0;
};

/// Largest step for which small motions stay bounded [s]. With the tangent K and the
/// dashpots' matrix C on the free components
///
///     semi-implicit Euler, Verlet   4 M - 2 dt C - dt^2 K is positive definite;
///                                   without dashpots 2/omega_max
///     explicit Euler                C - dt K and 4 M - 2 dt C + dt^2 K are not negative
///                                   along any direction; without dashpots 0. Exact where
///                                   C and K share their modes, and on the safe side
///                                   elsewhere
///     implicit Euler                infinite
///
/// Infinite where nothing swings, K having no positive eigenvalue. K and C are applied by
/// central differences of the forces; largest eigenvalues by Lanczos' method from a fixed
/// start vector, to about 1e-4.
/// Source: the amplification polynomials M (z-1)^2 + dt C (z-1) + dt^2 K z of v += dt
/// a(x, v), x += dt v, which first leaves the unit circle at z = -1, and M (z-1)^2 +
/// dt C (z-1) + dt^2 K of the explicit scheme, whose roots have the product
/// 1 - dt c + dt^2 k.
double largest_stable_step(const SmallMotions& system, Integrator integrator);

/// The same about a state of the motion, or about rest, by the motion's own forces in
/// place of the system's, and with an amplitude for their precision. Leaves the motion in
/// that state. near: what was found in a state not far away, if anything was; see
/// stable_step_near.
StableStep largest_stable_step(SmallMotions system, Motion& motion, Precision precision,
                               const std::optional<State>& state, Integrator integrator,
                               const StableStep* near = nullptr);

}  // namespace springcheck::dynamics
