#pragma once

#include <memory>

#include "dynamics/motion.hpp"
#include "mss/networks/network.hpp"

namespace springcheck::mss {

/// Implicit Euler from rest. Each step solves
///
///     M (v1 - v0) = dt [f(x0 + dt v1, v1) + load]
///
/// for the velocities of the free components by Newton's method, with M + dt C + dt^2 K
/// factored by CHOLMOD; where that is not positive definite, with the negative
/// eigenvalues of the tangent's patches set to zero. C leaves out that the dashpots' axes
/// turn. Converged at a residual of 1e-10 of the norm of what it is the sum of; a step
/// that is not after 50 iterations throws std::runtime_error.
/// Source: Golec 2018, Eq. 2.16, of which Eq. 2.18 is the first iteration.
std::unique_ptr<dynamics::Motion> implicit_motion(const Mesh& mesh, const Scene& scene,
                                                  const Network& network,
                                                  double damping_ratio);

}  // namespace springcheck::mss
