#pragma once

#include <functional>

#include "statics/potential_energy.hpp"

namespace springcheck::statics {

/// Why an equilibrium path cannot be followed further as it is.
enum class PathEnd {
  full_load,    // it can
  bifurcation,  // the tangent loses definiteness, and the path goes on without stability
  limit_point,  // the tangent loses definiteness, and there is no equilibrium beyond
  rejected,     // the caller does not accept the next state
  solver        // Newton's method fails, though the tangent is far from singular
};

/// The last state of the path from rest that is stable and accepted.
struct PathLimit {
  PathEnd end;
  double load_fraction;       // of that state
  double next_load_fraction;  // tried last, and not reached; that of the full load: 1
  PotentialEnergy::State state;
  // Short of the full load, a unit vector of least curvature of the energy there, as it
  // goes to zero where definiteness is lost; of all components, 0 where held:
  Eigen::VectorXd critical_mode;
  double curvature;            // of the energy along it [N/m]
  double rest_curvature;       // about the least curvature at rest [N/m]
  double mode_rest_curvature;  // along the critical mode at rest [N/m]
  int steps;
};

/// Whether the caller takes a state for one of the path.
using AcceptState =
    std::function<bool(const Eigen::VectorXd& displacements, double load_fraction)>;

/// Follows the equilibrium path from rest to the full load and stops where its tangent
/// loses positive definiteness or a state is not accepted; found by bisection to
/// `resolution` of the load reached. Only tangents that are positive definite are used,
/// so that no other branch is reached.
///
/// At the limit the least curvature is below a tenth of that at rest. Where it is not to
/// the resolution, the load is bisected further, to 1e-6 of it: a mode of few nodes may
/// lose its curvature at once, and a slender body has a least one at rest, of bending,
/// that is small beside those of other modes. Where then it is not below a tenth of what
/// the same mode has at rest the solver is to blame.
///
/// The path's direction du/ds then tells a limit point from a bifurcation: along the
/// critical mode it grows like the inverse of the mode's curvature at the one, and not at
/// the other, imperfections aside. It is called a limit point where du/ds has more than a
/// hundredth of the mode, and that has grown, since a state a thirty-second of the load
/// or a little more before, by more than the curvature's root has fallen.
PathLimit follow_to_limit(PotentialEnergy& potential, double resolution,
                          const AcceptState& accept);

}  // namespace springcheck::statics
