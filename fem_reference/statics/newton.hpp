#pragma once

#include "fem_reference/statics/elasticity.hpp"

namespace springcheck::fem_reference {

/// Only who follows a path knows whether what was found is astray, off it.
enum class NewtonOutcome { converged, indefinite, inverted, stalled, astray };

/// Tangents that Newton's method accepts at its iterates.
enum class Tangents { definite, any };

struct NewtonResult {
  NewtonOutcome outcome;
  Elasticity::Internal internal;  // of the last iterate
  Eigen::VectorXd displacements;  // of the last iterate
  double residual;                // relative
  bool definite;                  // the tangent at the last iterate
  int force_evaluations;
};

/// Newton's method on the free nodes for constant nodal `load` [N], from `start`, whose
/// prescribed entries stay.
///
/// Line search: a step is halved until the total energy W - load.u falls (where the
/// tangent is positive definite) or the residual does. Converged: residual below 1e-10 of
/// the larger of the reactions and the load, or at round-off. On return with `converged`
/// the body is linearised at the result and ready for step().
///
/// `inverted`: det F <= 0 at an integration point and a law that cannot have it.
NewtonResult newton(Elasticity& body, Eigen::VectorXd start, const Eigen::VectorXd& load,
                    Tangents tangents);

}  // namespace springcheck::fem_reference
