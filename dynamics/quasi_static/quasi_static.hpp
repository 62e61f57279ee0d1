#pragma once

#include "dynamics/marching/march.hpp"
#include "dynamics/quasi_static/remembering_body.hpp"
#include "meshing/basics/stopwatch.hpp"

namespace springcheck::dynamics {

/// So slowly that no inertia counts.
struct QuasiStaticSettings {
  LoadPath load;
  int steps;  // equal ones on each straight piece of the load
};

/// Moves a body through equilibria, one at the end of each step of time, in which its
/// memories are those after the step.
///
/// An equilibrium is found by Newton's method with the tangents of the body, from the
/// state that the tangent predicts for the supports' way; a step of the method is halved
/// until the residual falls, or where the tangent is not positive definite, or was not in
/// the equilibrium before, until the forces do not turn against it. Where an equilibrium
/// is not stable, the softest mode leads away from it, and to a stable one if there is
/// one near: a column buckles. Converged: the residual is below 1e-9 of the force scale.
/// A search that passed unstable states may have jumped to another branch, such as a
/// smaller turn of a plate: where it changes a displacement gradient by more than 1/2
/// from the prediction it counts as none.
///
/// A step of time that finds no equilibrium is halved, down to 1/64; then the status is
/// no_equilibrium if a jump was found, else not_converged, and the solution that of the
/// last state.
///
/// Each equilibrium is judged by the tangent of a further step in which nothing moves, a
/// twentieth of the time between the load's turning points, however long the steps are:
/// the more time the memories have to give way the earlier a body is not stable. Where
/// the tangent is not positive definite at the end, the status is indefinite;
/// definite_up_to is the load fraction of the last equilibrium before the first that is
/// not stable, or was left for one that is.
///
/// Observers are shown the moments that they ask for, as steps reach them; there are no
/// checkpoints. The solution has largest_shear_strain; its set-up began with `setup`.
Solution find_quasi_static(const Mesh& mesh, const Scene& scene, RememberingBody& body,
                           const QuasiStaticSettings& settings,
                           const Observers& observers = {}, const Stopwatch& setup = {});

}  // namespace springcheck::dynamics
