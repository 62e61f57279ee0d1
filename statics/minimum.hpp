#pragma once

#include <random>

#include "statics/potential_energy.hpp"

namespace springcheck::statics {

/// Tangents that a search goes on from.
enum class Tangents { definite, any };

struct Minimum {
  PotentialEnergy::State state;  // of the last iterate
  bool found;
  bool definite;    // the true tangent there; `potential` has its factor
  bool undecided;   // stationary; whether the tangent is definite could not be told
  bool crossed;     // an iterate before the last had an indefinite tangent
  bool ran_away;    // the energy fell without a minimum nearby
  bool inverted;    // the search ended where a cell is inside out and the law ends
  double residual;  // relative, see find_equilibrium
  int iterations;   // Newton's
};

/// Looks for a minimum of the energy from `start`, under the load that `potential` has;
/// find_equilibrium describes the method. Asked for definite tangents it ends at the
/// first one that is not. With `found` but not `definite` the state is
/// stationary, its tangent is not positive definite, and no direction of negative
/// curvature lowers the energy. The search ends without a minimum after 150 iterations,
/// when the energy cannot be lowered, or when the largest cell has grown fourfold since
/// the start: with a negative volume modulus the energy has no lower bound.
Minimum minimise(PotentialEnergy& potential, Eigen::VectorXd start,
                 std::mt19937_64& random, Tangents tangents = Tangents::any);

}  // namespace springcheck::statics
