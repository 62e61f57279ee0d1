#pragma once

#include "tissue/bipower_law.hpp"

namespace springcheck::tissue {

/// Torque on a disc of the radius R [m] between two plates, one of which turns so that
/// the rim reaches the strain gamma >= 0 at the constant rate r > 0 [1/s]:
///
///     M = 2 pi int_0^R sigma(gamma x/R, r x/R) x^2 dx
///       = 2 pi R^3 {sigma_linear/4 + sigma_hardening/(p+4)}     [N m]
///
/// with the parts of constant_rate_stress at the rim: all radii have turned for the same
/// time, at which the parts go with x and x^(p+1). Holds for discs in homogeneous
/// torsion, whose height is kept.
double disc_torque(const BipowerLaw& law, double rim_strain, double rim_rate,
                   double radius);

/// The rim's stress that a linear elastic disc of that torque would have [Pa]:
///
///     2 M/(pi R^3)
double apparent_stress(double torque, double radius);

}  // namespace springcheck::tissue
