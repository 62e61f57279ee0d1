#pragma once

#include "tissue/maxwell_branches.hpp"

namespace springcheck::tissue {

/// Tissue as a solid: what it is in simple shear, and how much harder its volume is to
/// change than its shape.
struct Solid {
  MaxwellModel shear;
  double bulk_ratio;  // r = K/G [-], above 0
};

/// Throws InputError where a parameter is out of its range.
void check(const Solid& solid);

/// K/G of an elastic solid of the Poisson ratio nu in (-1, 1/2):
///
///     r = 2 (1 + nu)/(3 (1 - 2 nu))
///
/// 500 at nu = .499. Throws InputError outside. Source: linear elasticity.
double bulk_ratio_of(double poisson_ratio);

/// sum G_i, the shear modulus that a sudden small strain meets [Pa]; the dashpot, which
/// such a strain would find rigid, is left out.
double instantaneous_modulus(const MaxwellModel& model);

}  // namespace springcheck::tissue
