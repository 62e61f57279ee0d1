#pragma once

#include "fem_reference/laws/dilatation.hpp"
#include "meshing/loads/scene.hpp"

namespace springcheck::fem_reference {

/// Hooke's law of small strain, eps = (H + H^T)/2:
///
///     psi = mu dev(eps):dev(eps) + U(t),   t = tr eps,   U = K/2 t^2,
///     P = 2 mu dev(eps) + K t I,           K = lambda + 2 mu/3
///
/// Validity: small strain and small rotation, off by terms of second order in H.
/// Source: Hughes, The Finite Element Method (1987), section 2.7.
struct Hooke {
  double shear_modulus;  // mu [Pa]
  double bulk_modulus;   // K [Pa]

  /// The shape part, mu dev(eps):dev(eps) [Pa], its stress and its tangent dP/dF.
  [[nodiscard]] double energy(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix3 stress(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix9 tangent(const Matrix3& displacement_gradient) const;

  [[nodiscard]] static Dilatation dilatation(const Matrix3& displacement_gradient);
  [[nodiscard]] VolumetricEnergy volumetric_energy(double dilatation) const;
};

Hooke hooke(const LameConstants& lame);

}  // namespace springcheck::fem_reference
