#pragma once

#include "mss/networks/deformation.hpp"

namespace springcheck::mss {

/// Axes of virtual springs: the 6 of the icosahedron, or those and the 10 of the
/// dodecahedron dual to it.
enum class Axes { six, sixteen };

/// One number for each axis.
using AxisValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 16, 1>;

/// |F n| - 1 along the axes n, to the digits of small strains.
AxisValues axis_strains(Axes axes, const Matrix3& displacement_gradient);

/// A law made of springs along axes n in a cell's mean deformation, and of a volume
/// correction; energy per undeformed volume [Pa] with s, t and U of the strain measure
///
///     psi(F) = sum w/2 s(|F n|)^2 + U(t(F))
///     P = dpsi/dF = sum w s s' d (x) n/|d| + U' dt/dF,   d = F n
///     dP_iJ/dF_kL = sum w [a delta_ik + (b - a) d_i d_k/|d|^2] n_J n_L + ...,
///                   a = s s'/|d|,  b = s'^2 + s s''
///
/// w is 15 mu times the axis's weight in a mean over directions: 1/6 of each of six; of
/// sixteen 25/420 of each of the icosahedron's, 27/420 of the dodecahedron's. With six,
/// means of polynomials in n up to degree 5 are exact, with sixteen up to degree 9. At
/// small strain both are Hooke's law with the shear modulus mu and lambda = mu + kappa,
/// and with green both are St-Venant-Kirchhoff's.
/// Every function takes the displacement gradient H = F - I. A direction pressed to a
/// point pulls nowhere.
///
/// Source: own; kappa as in Golec 2018, Eq. 5.36.
struct VirtualSprings {
  double shear_modulus;   // mu [Pa]; 0: no springs
  double volume_modulus;  // kappa [Pa]; 0: no correction
  StrainMeasure measure = StrainMeasure::engineering;
  Axes axes = Axes::six;

  [[nodiscard]] double energy(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix3 stress(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix9 tangent(const Matrix3& displacement_gradient) const;
};

}  // namespace springcheck::mss
