#pragma once

#include "mss/networks/network.hpp"
#include "statics/systems/linear_solver.hpp"

namespace springcheck::mss {

/// Static equilibrium as a minimum of the total energy, followed from rest to the full
/// load.
///
/// Load steps, the first so long that the springs turn and stretch by .06 on average:
/// predictor through the tangent from the prescribed increments, then Newton's method
/// with an energy line search. Where the tangent is not positive definite the step uses
/// the patches' matrices with negative eigenvalues set to zero. A state counts as a
/// minimum when its true tangent has a Cholesky factor, or passes the iterative solver's
/// test (statics::IterativeSolver::is_definite); near a saddle the search leaves along
/// negative curvature, the most negative where the solver is direct (`seed` starts the
/// iteration that finds it, and so decides between equal directions).
///
/// A minimum counts only where the path leads there and the body shows the turn of its
/// plates (shows_imposed_turn): layers of cells that it twists by more than half of one
/// come right again as if they were twisted the other way. A search that met indefinite
/// tangents may have passed a bifurcation, or have jumped to another branch, such as a
/// smaller turn of a plate. Its minimum is unloaded to the last state's load, and counts
/// when that leads back to the last state.
///
/// A step that finds no minimum, or one that does not count, is halved, down to 1/1024 of
/// the load, or until searches that did not converge have taken 450 iterations; then the
/// status is no_equilibrium if the energy fell without end or the steps led to another
/// branch, and not_converged otherwise. The solution's definite_up_to is about the states
/// that the path keeps: a saddle that it left for a minimum, wrinkled perhaps, does not
/// count.
///
/// With noise every free component of the last state is moved by up to that many mean
/// cell edges, at random from the seed, and the minimum is sought from there: a state
/// that is left so was not one to rely on.
///
/// Converged: residual below 1e-10 of the norm of the nodal forces, or below what the
/// rounding of the positions does to them.
Solution find_equilibrium(
    const Mesh& mesh, const Scene& scene, const Network& network, unsigned seed,
    statics::LinearSolver linear_solver = statics::LinearSolver::automatic,
    double noise = 0);

}  // namespace springcheck::mss
