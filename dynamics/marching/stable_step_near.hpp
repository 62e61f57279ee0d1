#pragma once

#include "dynamics/marching/stable_step.hpp"

namespace springcheck::dynamics {

/// The limit of semi-implicit Euler and Verlet, to about 1 %, from what was found in a
/// state not far away: some twenty forces where a search from nothing takes hundreds. It
/// starts from the motion found there, and a tenth of noise: a motion of another kind
/// that becomes the stiffest grows out of it, within a few looks where it is stiffer by
/// 5 %. Infinite where nothing near swings.
///
/// Method: ascent to the largest eigenvalue in the plane of residual and last direction
/// (locally optimal conjugate gradients; Knyazev 2001, SIAM J. Sci. Comput. 23, 517).
StableStep stable_step_near(const SmallMotions& system, const StableStep& known);

}  // namespace springcheck::dynamics
