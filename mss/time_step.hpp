#pragma once

#include "mss/network.hpp"

namespace springcheck::mss {

/// Largest stable step of semi-implicit (symplectic) Euler for small motions about the
/// rest state [s]: the largest dt for which
///
///     4 M - 2 dt C - dt^2 K   is positive definite on the free components,
///
/// K the tangent and C the dashpots' matrix at rest. Without dashpots this is
/// 2/omega_max. Infinite where nothing swings: K has no positive eigenvalue. Largest
/// eigenvalues by Lanczos' method from a fixed start vector, to about 1e-4.
/// Source: the amplification polynomial of v += dt a(x, v), x += dt v,
/// M(z-1)^2 + dt C(z-1) + dt^2 K z, first leaves the unit circle at z = -1.
///
/// damping_ratio: zeta of add_dashpot_forces. is_free: one entry per component, 3 node +
/// component.
double largest_stable_step(const Network& network, double damping_ratio,
                           const std::vector<bool>& is_free);

}  // namespace springcheck::mss
