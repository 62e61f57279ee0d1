#pragma once

#include <functional>
#include <optional>
#include <span>

#include "dynamics/integrators.hpp"
#include "dynamics/motion.hpp"
#include "dynamics/precision.hpp"

namespace springcheck::dynamics {

/// The internal forces in a state [N]: springs, dashpots and the like, without loads.
using ForcesAt = std::function<std::vector<Vector3>(const State& state)>;

/// A system about which small motions are looked at.
struct SmallMotions {
  ForcesAt forces;
  State state;                     // K and C are those of this state
  std::span<const double> masses;  // [kg] of each node
  std::vector<bool> is_free;       // of each component, 3 node + component
  double amplitude;                // [m] by which nodes are moved to find K
  bool has_dashpots;               // without, C is zero and not looked for
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
/// that state.
double largest_stable_step(SmallMotions system, Motion& motion, Precision precision,
                           const std::optional<State>& state, Integrator integrator);

/// SmallMotions::amplitude in mean cell edges, in double precision: forces keep half
/// their digits at least, and what is not linear stays in the last.
inline constexpr double probe = 1e-4;

}  // namespace springcheck::dynamics
