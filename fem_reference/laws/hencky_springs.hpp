#pragma once

#include <vector>

#include "fem_reference/laws/spring_direction.hpp"
#include "fem_reference/laws/tensors.hpp"

namespace springcheck::fem_reference {

/// The stretch that springs see: that along them, |F n|, or its isochoric part,
/// J^(-1/3) |F n|.
enum class SpringStretch { whole, isochoric };

/// Springs whose energy e is of the logarithm q of the stretch that they see, such that
/// they follow Hencky's law in large strain. With d = F n, m = d/|d|, theta = 0 or 1/3 by
/// whole or isochoric stretch:
///
///     psi = sum w e(q)     q = ln |d| - theta ln J
///     tau = sum w e'(q) (m (x) m - theta I)     P = tau F^-T
///
///     whole      e' = (l^2 - 1)/(2 l^2 (.7 + .3 l^2)), l = e^q: fitted to Hencky's law
///                over random states of the thesis's lattices within 20 %
///     isochoric  e' = (1 - e^(-9 q/2))/(9/2): of springs in all directions Hencky's to
///                the third order
///
/// Validity: det F > 0. Source: own.
struct HenckySprings {
  const std::vector<SpringDirection>& springs;
  SpringStretch stretch;

  [[nodiscard]] double energy(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix3 stress(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix9 tangent(const Matrix3& displacement_gradient) const;
};

}  // namespace springcheck::fem_reference
