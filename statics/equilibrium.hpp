#pragma once

#include <string>

#include "meshing/scene.hpp"
#include "statics/elastic_body.hpp"
#include "statics/loading.hpp"
#include "statics/systems/linear_solver.hpp"

namespace springcheck::statics {

/// What an equilibrium is searched with.
struct Search {
  unsigned seed = 1;
  LinearSolver linear_solver = LinearSolver::automatic;
  double noise = 0;  // in mean cell edges
};

/// The last state of a path, and how it was found. Vectors hold all components.
struct Equilibrium {
  SolveStatus status;
  std::string reason;
  Eigen::VectorXd displacements;  // [m]
  Eigen::VectorXd reactions;      // of the supports [N], 0 on free components
  double strain_energy;           // [J]
  double load_fraction;
  std::optional<double> definite_up_to;  // load fraction, where definiteness was lost
  std::optional<double> critical_wavelength;  // in cell edges, by last_stable_equilibrium
  int steps;
  int force_evaluations;
  std::optional<int> linear_iterations, factorisations;
  double setup_wall_s;
};

/// Static equilibrium as a minimum of the total energy, followed from rest to the full
/// load.
///
/// Load steps, the first so long that the displacements' mean gradient is .06: predictor
/// through the tangent from the prescribed increments, then Newton's method with an
/// energy line search. Where the tangent is not positive definite the step uses the
/// patches' matrices with negative eigenvalues set to zero. A state counts as a minimum
/// when its true tangent has a Cholesky factor, or passes the iterative solver's test
/// (IterativeSolver::is_definite); near a saddle the search leaves along negative
/// curvature, the most negative where the solver is direct (the seed starts the iteration
/// that finds it, and so decides between equal directions).
///
/// A minimum counts only where the path leads there and the body follows its supports
/// (Loading::follows_supports). A search that met indefinite tangents may have passed a
/// bifurcation, or have jumped to another branch, such as a smaller turn of a plate. Its
/// minimum is unloaded to the last state's load, and counts when that leads back to the
/// last state.
///
/// A step that finds no minimum, or one that does not count, is halved, down to 1/1024 of
/// the load, or until searches that did not converge have taken 450 iterations; then the
/// status is no_equilibrium if the energy fell without end or the steps led to another
/// branch, and not_converged otherwise. definite_up_to is about the states that the path
/// keeps: a saddle that it left for a minimum, wrinkled perhaps, does not count.
///
/// With noise every unknown of the last state is moved by up to that many mean cell
/// edges, at random from the seed, and the minimum is sought from there: a state that is
/// left so was not one to rely on.
///
/// Converged: residual below 1e-10 of the norm of the nodal forces, or below what the
/// rounding of the nodes' places does to them.
Equilibrium find_equilibrium(ElasticBody& body, const Loading& loading,
                             const Search& search);

}  // namespace springcheck::statics
