#pragma once

#include <algorithm>

#include "mss/networks/stiffness.hpp"

namespace springcheck::mss {

/// Young's modulus of a lattice along its edges at small strain [Pa]:
///
///     E_100 = C_11 - 2 C_12^2 / (C_11 + C_12)
///     C_11 = (k_e + 2 k_f + 4/3 k_c)/h + kappa     C_12 = (k_f + 4/3 k_c)/h + kappa
///
/// cell_edge  h [m]
///
/// Source: cubic symmetry, and C = (1/V) sum k/l^2 r r r r over a cell's springs.
/// 0 where it or C_11 + C_12 is not positive: such a lattice is unstable at rest.
inline double axial_modulus(const LatticeConstants& lattice, double cell_edge) {
  const auto& [k, kappa] = lattice;
  const double C_12 = (k.face_diagonal + 4. / 3 * k.inner_diagonal) / cell_edge + kappa;
  const double C_11 = (k.edge + k.face_diagonal) / cell_edge + C_12;
  if (!(C_11 + C_12 > 0)) return 0;
  return std::max(0., C_11 - 2 * C_12 * C_12 / (C_11 + C_12));
}

}  // namespace springcheck::mss
