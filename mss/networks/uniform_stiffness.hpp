#pragma once

#include "mss/networks/stiffness.hpp"

namespace springcheck::mss {

/// All springs of a cubic cell, its edges, face and inner diagonals, of one stiffness k,
/// so that a body in uniaxial stress along the lattice's axis has Young's modulus E:
///
///     k = 19 E h/144,   of the lattice k_e = 4 k, k_f = 2 k, k_c = k
///
/// Then C_11 = 28 k/(3 h), C_12 = C_44 = 10 k/(3 h), with which E_100 = C_11 - 2 C_12^2 /
/// (C_11 + C_12) = 144 k/(19 h). Whatever the material's Poisson ratio, along the axes it
/// is C_12/(C_11 + C_12) = 5/19 = 0.263. Not isotropic: Zener's ratio 2 C_44/(C_11 -
/// C_12) is 10/9, and along the space diagonal Young's modulus is 95/87 of E.
///
/// young_modulus  E [Pa]
/// cell_edge      h [m]
///
/// Source: own, by C = (1/V) sum k/l^2 r r r r over a cell's springs.
inline LatticeStiffness uniform_stiffness(double young_modulus, double cell_edge) {
  const double k = 19. / 144 * young_modulus * cell_edge;
  return {.edge = 4 * k, .face_diagonal = 2 * k, .inner_diagonal = k};
}

}  // namespace springcheck::mss
