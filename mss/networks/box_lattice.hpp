#pragma once

#include <array>
#include <optional>

#include "meshing/cell_geometry.hpp"

namespace springcheck::mss {

/// Edges a, b, c of a cell that is a rectangular box in any orientation [m], along 0-1,
/// 0-3, 0-4; nothing for any other cell. Judged to 1e-6 of the edge of a cube of the same
/// volume.
std::optional<std::array<double, 3>> box_edges(const CornerPositions& x);

/// Whether the three edges of a box are equal, to 1e-6 of the edge of a cube of the same
/// volume.
bool is_cube(const std::array<double, 3>& edges);

/// Springs that a box a x b x c adds to the lattice, as q = k/l^2 [N/m^3]: a quarter of a
/// lattice edge, half of a face diagonal, an inner diagonal.
struct BoxLattice {
  std::array<double, 3> edge;           // along a, b, c
  std::array<double, 3> face_diagonal;  // of the faces across a, b, c
  double inner_diagonal;
};

/// The springs that have the shear modulus mu and lambda = mu, for every q_d:
///
///     q_a  = 3 mu V/(4 a^4) - mu V/(4 a^2) (1/b^2 + 1/c^2) + q_d     and cyclic
///     q_bc = mu V/(4 b^2 c^2) - q_d                                  and cyclic
///
/// q_d is the one for which the smallest of all q is largest, or the nearest below it
/// that keeps k_f/k_c = 2 q_bc (b^2 + c^2)/(q_d (a^2 + b^2 + c^2)) at 1 or more on all
/// faces, where there is any without a negative q; near the limits of what is covered
/// there is none, and a face's diagonals may go to zero. The ratio is never above 3.7
/// (measured). Nothing when some q is negative for every q_d: boxes 1 : 1 : c are covered
/// for c between 1/sqrt(3) and sqrt(3).
///
/// Source: own derivation. In C = (1/V) sum q r r r r over a cell's springs, C_bbcc =
/// mu gives q_bc, then C_aaaa = 3 mu gives q_a, as 4 q_a a^4 + 4 (q_ab + q_ac) a^4 +
/// 4 q_d a^4 = 3 mu V. Both are shear_modulus_form on a cube, where q_d = mu/(8 h) means
/// A = 4/3.
std::optional<BoxLattice> box_lattice(double shear_modulus,
                                      const std::array<double, 3>& edges);

}  // namespace springcheck::mss
