#pragma once

#include "fem_reference/laws/cauchy_born.hpp"

namespace springcheck::fem_reference {

/// Homogeneous displacement gradient under uniaxial stress along z: H = diag(a, b,
/// strain) with
///
///     P_xx = P_yy = 0,   P = sum of the springs' stress and U'(t) dt/dF
///
/// by Newton's method from a = b = 0. The other components of P vanish by the symmetry of
/// the directions that LatticeDirection knows.
///
/// Throws std::runtime_error where Newton's method finds none: the lattice has lost its
/// lateral minimum.
Matrix3 uniaxial_stress_state(const CauchyBorn& law, double strain);

}  // namespace springcheck::fem_reference
