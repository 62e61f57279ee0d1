#pragma once

#include <string>

#include "meshing/basics/stopwatch.hpp"
#include "meshing/loads/scene.hpp"
#include "statics/elastic_body.hpp"
#include "statics/loading.hpp"
#include "statics/search.hpp"

namespace springcheck::statics {

/// The last state of a path, and how it was found. Vectors hold all components.
struct Equilibrium {
  SolveStatus status;
  std::string reason;
  Eigen::VectorXd displacements;  // [m]
  Eigen::VectorXd reactions;      // of the supports [N], 0 on free components
  double strain_energy;           // [J]
  double load_fraction;
  std::optional<double> definite_up_to;  // load fraction, where definiteness was lost
  std::optional<double> critical_wavelength;  // by last_stable_equilibrium
  int steps;
  int force_evaluations;
  std::optional<int> linear_iterations, factorisations;
  double setup_wall_s;
};

/// Adds to a reason how many linear systems were solved less accurately than asked
/// (PotentialEnergy::truncated).
void tell_truncated(Equilibrium& equilibrium, int truncated);

/// The Solution of an equilibrium on the body's nodes, with deformed lever arms.
Solution solution_of(const Equilibrium& equilibrium);

/// Static equilibrium as a minimum of the total energy, followed from rest to the full
/// load.
///
/// The first load step is so long that the displacements' mean gradient is .06, each
/// later one twice as long as the one before, up to .5; a linear body's is the whole
/// load. A step begins with a predictor through the tangent from the prescribed
/// increments and the load's, and goes on by Newton's method with an energy line search.
/// Where the tangent is not positive definite the step uses the patches' matrices with
/// negative eigenvalues set to zero. A state counts as a minimum when its true tangent
/// has a Cholesky factor, or passes the iterative solver's test
/// (IterativeSolver::is_definite); near a saddle the search leaves along negative
/// curvature, the most negative where the solver is direct (the seed starts the iteration
/// that finds it, and so decides between equal directions).
///
/// A minimum counts only where the path leads there and the body follows its supports
/// (Loading::follows_supports). A search that met indefinite tangents, or went farther
/// than a first step, may have passed a bifurcation, or have jumped to another branch,
/// such as a smaller turn of a plate. Its minimum is unloaded to the last state's load,
/// and counts when that leads back to the last state.
///
/// A step that finds no minimum, or one that does not count, is halved, and from there on
/// definite tangents alone are gone on from, which costs little, until the load that it
/// failed at is reached. Below 2/1024 of the load a search that goes on from any tangent
/// decides: where it finds nothing either, the status is no_equilibrium if it met
/// indefinite tangents, the energy fell without end, or it led to another branch, and
/// not_converged otherwise. Where an accepted search met indefinite tangents and its
/// minimum does not lead back to first order, the reason says between which loads the
/// path may branch, also with ok. definite_up_to is the load of the last state before the
/// first one that is no minimum, or before a branch that small steps have shown; rest
/// counts.
///
/// With noise every unknown of the last state is moved by up to that many mean cell
/// edges, at random from the seed, and the minimum is sought from there: a state that is
/// left so was not one to rely on.
///
/// A state has converged where the residual is below 1e-10 of the norm of the nodal
/// forces or of the load, or below what the rounding of the nodes' places does to them;
/// or below 1e-9 where it has stopped falling. The set-up began with `setup`.
Equilibrium find_equilibrium(ElasticBody& body, const Loading& loading,
                             const Search& search, const Stopwatch& setup = {});

}  // namespace springcheck::statics
