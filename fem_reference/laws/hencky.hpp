#pragma once

#include "fem_reference/laws/dilatation.hpp"
#include "fem_reference/laws/shape_state.hpp"
#include "meshing/loads/scene.hpp"

namespace springcheck::fem_reference {

/// Hencky's hyperelasticity, quadratic in logarithmic strain. With the principal
/// stretches l_a (l_a^2 the eigenvalues of C = F^T F, N_a its eigenvectors) and e_a = ln
/// l_a:
///
///     psi = mu sum (e_a - ln J/3)^2 + U(t),   t = J - 1,   U = K/2 (ln J)^2
///     S_a = 2 mu (e_a - ln J/3)/l_a^2,        P = F sum S_a N_a (x) N_a   (shape part)
///
/// Tangent: dP_iJ/dF_kL = delta_ik S_JL + sum D_ab v_aa v_bb^T
///                        + sum_{a != b} g_ab/2 (v_ab v_ab^T + v_ab v_ba^T)
///
/// with v_ab = F N_a (x) N_b, D_ab = dS_a/dE_b and the divided difference
/// g_ab = (S_a - S_b)/(E_a - E_b), E_a = (l_a^2 - 1)/2, written with log(1 + x)/x so that
/// equal stretches need no case of their own.
///
/// Validity: det F > 0, any rotation; strongly elliptic for principal stretches between
/// about 0.212 and 1.396.
/// Source: Hencky, Z. Techn. Phys. 9 (1928) 215; spectral form: Ogden, Non-linear Elastic
/// Deformations (1984), section 6.1; ellipticity: Bruhns, Xiao and Meyers, Proc. R. Soc.
/// A 457 (2001) 2207.
struct Hencky {
  double shear_modulus;  // mu [Pa]
  double bulk_modulus;   // K [Pa]

  /// The shape part of psi [Pa], its stress and its tangent dP/dF.
  [[nodiscard]] double energy(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix3 stress(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix9 tangent(const Matrix3& displacement_gradient) const;
  /// The first two at once, for half of the time: most of it is that of the directions.
  [[nodiscard]] ShapeState shape_state(const Matrix3& displacement_gradient) const;

  [[nodiscard]] static Dilatation dilatation(const Matrix3& displacement_gradient);
  [[nodiscard]] VolumetricEnergy volumetric_energy(double dilatation) const;
};

Hencky hencky(const LameConstants& lame);

}  // namespace springcheck::fem_reference
