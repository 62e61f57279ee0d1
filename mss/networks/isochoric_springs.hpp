#pragma once

#include "mss/networks/axes.hpp"
#include "mss/networks/deformation.hpp"

namespace springcheck::mss {

/// Springs that see a cell's shape alone, the isochoric stretch J^(-1/3) |F n| along the
/// axes n, J = det F; energy per undeformed volume [Pa]
///
///     psi = mu sum w om(q)      q = ln |F n| - ln J/3
///     om = (e^(-b q) - 1 + b q)/b^2     om' = (1 - e^(-b q))/b     b = 9/2
///     P = mu sum w om' s        s = dq/dF = d (x) n/|d|^2 - F^-T/3,   d = F n
///     dP/dF = mu sum w [om'' s (x) s + om' ds/dF]
///
/// Along all directions these are the shape part of Hencky's law, mu H':H', H' the
/// deviator of ln V, to the third order in H'; the fourth is left. Hence b: in
/// om = q^2/2 + c q^3/3 + ... the third order is
///
///     15 mu [2/15 - (1 - c/3) 8/105] tr H'^3
///
/// and vanishes for c = -b/2 = -9/4. Stress of springs and K/2 ln^2 J off Hencky's over
/// random principal stretches of +-20 %, root of the mean square [%]:
///
///     nu                0    .25  .4   .499
///     6 axes            28   16   6.7  3.8
///     16 axes           1.3  .8   .3   .2      (at +-10 %: .17, .10, .04, .01)
///     25 axes           .29  .17  .07  .04
///     all directions    .13  .08  .03  .02
///
/// Every function takes H = F - I; where det F <= 0 the energy is infinite, stress and
/// tangent are 0.
///
/// Source: own (om and b), by third-order means over directions; a microplane law: Carol,
/// Jirasek and Bazant, Int. J. Solids Struct. 41 (2004) 511.
struct IsochoricSprings {
  double shear_modulus;  // mu [Pa]
  Axes axes;

  [[nodiscard]] double energy(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix3 stress(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix9 tangent(const Matrix3& displacement_gradient) const;
};

}  // namespace springcheck::mss
