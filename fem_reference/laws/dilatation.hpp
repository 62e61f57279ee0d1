#pragma once

#include "fem_reference/laws/tensors.hpp"

namespace springcheck::fem_reference {

/// A scalar measure of volume change t at a point, with its derivatives by F.
struct Dilatation {
  double value;    // t
  Matrix3 first;   // dt/dF
  Matrix9 second;  // d2t/dF2
};

/// The measures that the laws use, of the displacement gradient H = F - I:
///
///     trace of small strain    t = tr H                         dt/dF = I
///     trace of Green strain    t = tr (F^T F - I)/2             dt/dF = F
///     Jacobian                 t = det F - 1                    dt/dF = cof F
///
/// Formed from H without the cancellation that F - I would bring:
/// det F - 1 = tr H + [(tr H)^2 - tr H^2]/2 + det H.
Dilatation small_strain_trace(const Matrix3& displacement_gradient);
Dilatation green_strain_trace(const Matrix3& displacement_gradient);
Dilatation volume_change(const Matrix3& displacement_gradient);

/// Energy per undeformed volume of a dilatation, U(t) [Pa], and its derivatives.
struct VolumetricEnergy {
  double value;
  double first;
  double second;
};

/// U = modulus/2 t^2.
VolumetricEnergy quadratic(double modulus, double dilatation);

/// U = modulus/2 (ln J)^2 of t = J - 1 > -1.
VolumetricEnergy logarithmic(double modulus, double dilatation);

/// U = cubic_modulus C(ln J) of t = J - 1 > -1: C(q) = q^3/3 to J = 1/2; below, where
/// that would fall without bound, C' = 2 p^2 - (q + 2 p)^2, p = ln 2, goes on with its
/// slope.
VolumetricEnergy cubic_logarithmic(double cubic_modulus, double dilatation);

}  // namespace springcheck::fem_reference
