#pragma once

#include <functional>
#include <optional>
#include <string>

#include "fem_reference/statics/elasticity.hpp"

namespace springcheck::fem_reference {

/// What drives the body, as the load fraction s goes from 0 to 1.
struct LoadProgram {
  /// Nodal vector of prescribed displacements at s [m]; entries of free nodes are not
  /// read.
  std::function<Eigen::VectorXd(double)> displacements;
  Eigen::VectorXd forces;  // external nodal forces at s = 1 [N], in proportion to s
  /// Whether displacements found at s belong to where the supports went by then, and not
  /// to another turn of theirs that ends in the same place.
  std::function<bool(const Eigen::VectorXd&, double)> follows_supports;
};

struct Equilibrium {
  SolveStatus status;
  std::string reason;
  Eigen::VectorXd displacements;  // [m] of the last equilibrium
  Eigen::VectorXd reactions;      // [N] on prescribed nodes, 0 elsewhere
  double energy;                  // [J]
  double load_fraction;
  std::optional<double> definite_up_to;  // load fraction, where definiteness was lost
  int steps;
  int force_evaluations;
};

/// Follows the equilibrium from rest to the full load. Each step predicts through the
/// tangent and corrects by Newton's method (newton.hpp); for Hooke's law the prediction
/// of the whole load is the answer. Steps are halved when Newton fails or meets an
/// indefinite tangent, doubled after success.
///
/// Where steps below 1/1024 still meet an indefinite tangent, the path is followed with
/// indefinite tangents allowed, so that a bifurcation is passed (`indefinite` if the
/// tangent is still so at the full load) and a limit point is not: `no_equilibrium`, if
/// the rates of displacement say so (limit_point.hpp). States found so count where they
/// lead back to the one before, to first order; all count only where they follow the
/// supports. A step that fails otherwise ends in
/// `not_converged`. Whenever definiteness was lost on the way, the reason says where,
/// also with `ok`.
Equilibrium find_equilibrium(Elasticity& body, const LoadProgram& program);

}  // namespace springcheck::fem_reference
