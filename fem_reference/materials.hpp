#pragma once

#include <Eigen/Core>

#include "fem_reference/solve.hpp"

namespace springcheck::fem_reference {

using Matrix3 = Eigen::Matrix3d;

/// Derivative of a 3x3 matrix with respect to another; entry (i + 3J, k + 3L) is
/// dP_iJ/dF_kL.
using Matrix9 = Eigen::Matrix<double, 9, 9>;

/// Strain of a law, from the displacement gradient H = F - I (forming F would lose the
/// digits of a tiny H):
///
///     Hooke                  eps = (H + H^T)/2
///     St-Venant-Kirchhoff    E = (F^T F - I)/2 = (H + H^T + H^T H)/2
///
/// Validity: eps for small strain and small rotation (off by terms of second order in H);
/// E for small strain and any rotation. At finite strain St-Venant-Kirchhoff is only a
/// definition: a bar's force has its extremum in compression at a stretch of 1/sqrt(3).
Matrix3 strain(Law law, const Matrix3& displacement_gradient);

/// An energy per undeformed volume [Pa = J/m^3] in terms of that strain e:
///
///     psi(e) = a e:e + b/2 (tr e)^2 + p tr e
struct EnergyDensity {
  double a;  // [Pa]
  double b;  // [Pa]
  double p;  // [Pa] a constant mean stress, 0 in the laws themselves
};

/// The laws are psi = mu e:e + lambda/2 (tr e)^2. q1_sri integrates two parts apart:
///
///     shape        mu dev(e):dev(e) = mu e:e - mu/3 (tr e)^2
///     volumetric   K/2 (tr e)^2,   K = lambda + 2 mu/3
enum class Part { whole, shape, volumetric };
EnergyDensity energy_density(Part part, const LameConstants& lame);

/// psi [Pa].
double energy(Law law, const EnergyDensity& psi, const Matrix3& displacement_gradient);

/// First Piola-Kirchhoff stress P = dpsi/dF [Pa]: force per undeformed area.
///
///     Hooke                  P = S
///     St-Venant-Kirchhoff    P = F S
///     S = dpsi/de = 2 a e + (b tr e + p) I
///
/// Source: Holzapfel, Nonlinear Solid Mechanics (2000), section 6.5.
Matrix3 stress(Law law, const EnergyDensity& psi, const Matrix3& displacement_gradient);

/// Consistent tangent dP/dF [Pa]:
///
///     St-Venant-Kirchhoff
///     dP_iJ/dF_kL = delta_ik S_JL + a (F_im F_km delta_JL + F_iL F_kJ) + b F_iJ F_kL
///
/// Hooke: the same with F = I and S = 0.
Matrix9 tangent(Law law, const EnergyDensity& psi, const Matrix3& displacement_gradient);

/// d(tr e)/dF: I for Hooke, F for St-Venant-Kirchhoff.
Matrix3 trace_derivative(Law law, const Matrix3& displacement_gradient);

}  // namespace springcheck::fem_reference
