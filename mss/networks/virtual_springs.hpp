#pragma once

#include "mss/networks/axes.hpp"
#include "mss/networks/deformation.hpp"

namespace springcheck::mss {

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
/// w is mu times the axis's weight. At small strain it is Hooke's law with the shear
/// modulus mu and lambda = mu + kappa, along whatever axes; with green it is
/// St-Venant-Kirchhoff's. With hencky the springs are IsochoricSprings, and what springs
/// oppose to a change of all lengths stands beside kappa: U = (kappa + 5 mu/3)/2 ln^2 J,
/// of Hencky's K = lambda + 2 mu/3.
/// Every function takes the displacement gradient H = F - I. A direction pressed to a
/// point pulls nowhere.
///
/// Source: kappa as in Golec 2018, Eq. 5.36; springs along directions are a microplane
/// law: Carol, Jirasek and Bazant, Int. J. Solids Struct. 41 (2004) 511.
struct VirtualSprings {
  double shear_modulus;        // mu [Pa]; 0: no springs
  VolumeModuli volume_moduli;  // of the correction
  StrainMeasure measure = StrainMeasure::engineering;
  Axes axes = Axes::six;

  [[nodiscard]] double energy(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix3 stress(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix9 tangent(const Matrix3& displacement_gradient) const;

  /// The moduli of U: the correction's, and with hencky the springs' share.
  [[nodiscard]] VolumeModuli moduli_of_volume() const;
};

}  // namespace springcheck::mss
