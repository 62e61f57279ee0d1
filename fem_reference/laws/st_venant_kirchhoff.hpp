#pragma once

#include "fem_reference/laws/dilatation.hpp"
#include "meshing/loads/scene.hpp"

namespace springcheck::fem_reference {

/// St-Venant-Kirchhoff, Hooke's law in Green strain E = (F^T F - I)/2:
///
///     psi = mu dev(E):dev(E) + U(t),   t = tr E,   U = K/2 t^2,
///     P = F S,   S = 2 mu dev(E) + K t I,          K = lambda + 2 mu/3
///     dP_iJ/dF_kL = delta_ik S_JL + mu (F_im F_km delta_JL + F_iL F_kJ)
///                   + (K - 2 mu/3) F_iJ F_kL
///
/// Validity: small strain, any rotation. At finite strain it is only a definition: a
/// bar's force has its extremum in compression at a stretch of 1/sqrt(3). Source:
/// Holzapfel, Nonlinear Solid Mechanics (2000), section 6.5.
struct StVenantKirchhoff {
  double shear_modulus;  // mu [Pa]
  double bulk_modulus;   // K [Pa]

  /// The shape part, mu dev(E):dev(E) [Pa], its stress and its tangent dP/dF.
  [[nodiscard]] double energy(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix3 stress(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix9 tangent(const Matrix3& displacement_gradient) const;

  [[nodiscard]] static Dilatation dilatation(const Matrix3& displacement_gradient);
  [[nodiscard]] VolumetricEnergy volumetric_energy(double dilatation) const;
};

StVenantKirchhoff st_venant_kirchhoff(const LameConstants& lame);

}  // namespace springcheck::fem_reference
