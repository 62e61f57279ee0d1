#pragma once

#include <Eigen/Core>

#include "meshing/mesh.hpp"

namespace springcheck::mss {

using Matrix3 = Eigen::Matrix3d;
/// On gradients stacked column by column: F_iJ is component 3 J + i.
using Matrix9 = Eigen::Matrix<double, 9, 9>;

/// det F - 1 of F = I + H, from H so that small changes keep their digits:
/// tr H + (tr^2 H - tr H^2)/2 + det H.
double volume_change(const Matrix3& displacement_gradient);

/// cof F = d(det F)/dF.
Matrix3 cofactor(const Matrix3& displacement_gradient);

/// d2(det F)/dF dF.
Matrix9 volume_hessian(const Matrix3& displacement_gradient);

/// |F n| - 1 along the six axes n of the icosahedron, to the digits of small strains.
Eigen::Vector<double, 6> axis_strains(const Matrix3& displacement_gradient);

/// A law made of springs along the six axes n of the icosahedron, which are isotropic
/// exactly, and of a volume correction; energy per undeformed volume [Pa]
///
///     psi(F) = (5 mu/4) sum (|F n| - 1)^2 + kappa/2 (det F - 1)^2
///     P = dpsi/dF = (5 mu/2) sum (1 - 1/|d|) d (x) n + kappa (det F - 1) cof F,  d = F n
///     dP_iJ/dF_kL = (5 mu/2) sum [(1 - 1/|d|) delta_ik + d_i d_k/|d|^3] n_J n_L + ...
///
/// At small strain it is Hooke's law with the shear modulus mu and lambda = mu + kappa.
/// Every function takes the displacement gradient H = F - I. A direction pressed to a
/// point pulls nowhere.
///
/// Source: sum n n n n over the six axes is 2/5 of the isotropic tensor; kappa as in
/// Golec 2018, Eq. 5.36.
struct VirtualSprings {
  double shear_modulus;   // mu [Pa]; 0: no springs
  double volume_modulus;  // kappa [Pa]; 0: no correction

  [[nodiscard]] double energy(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix3 stress(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix9 tangent(const Matrix3& displacement_gradient) const;
};

}  // namespace springcheck::mss
