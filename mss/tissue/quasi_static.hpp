#pragma once

#include "dynamics/march.hpp"
#include "mss/tissue/tissue_body.hpp"

namespace springcheck::mss {

/// The load grows in proportion to the time, from rest to the whole at the end, so slowly
/// that no inertia counts.
struct QuasiStaticSettings {
  double duration;  // [s]
  int steps;        // equal ones
};

/// Moves tissue through equilibria, one at the end of each step of time, in which its
/// memories are those after the step (tissue::stress_after).
///
/// An equilibrium is found by Newton's method with the symmetric part of the tangent (see
/// tissue_stiffness), shifted where it is not positive definite, from the state that the
/// tangent predicts for the supports' way; a step of the method is halved until the
/// residual falls. Converged: the residual is below 1e-9 of the norm of the nodal forces
/// that each cell's springs and volume force have apart, which balance at rest. A step of
/// time that finds no equilibrium is halved, down to 1/64; then the status is
/// not_converged, and the solution that of the last state.
///
/// Observers are shown the moments that they ask for, as steps reach them; there are no
/// checkpoints.
Solution find_quasi_static(const Mesh& mesh, const Scene& scene, const TissueBody& body,
                           const QuasiStaticSettings& settings,
                           const dynamics::Observers& observers = {});

}  // namespace springcheck::mss
