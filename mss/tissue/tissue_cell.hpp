#pragma once

#include "mss/deformation.hpp"
#include "tissue/memory.hpp"

// A cube of living tissue: what it remembers acts in its mean deformation, and is carried
// by springs without rest length along its edges and diagonals and by the volume force of
// Golec 2018, Eq. 5.17.

namespace springcheck::mss {

/// Positions of a hexahedron's nodes as columns, in the mesh's order [m].
using HexahedronPositions = Eigen::Matrix<double, 3, 8>;
/// On the positions stacked column by column.
using Matrix24 = Eigen::Matrix<double, 24, 24>;

/// F = [X Y Z]/h of the means X, Y, Z of the four edges along each of the cube's own axes
/// 0-1, 0-3, 0-4; h its edge at rest [m]. For a cube turned by R it is F R of the
/// deformation gradient, with which C = F^T F is in the cube's axes: an isotropic law
/// does not care.
/// Source: Golec 2018, Eq. 5.18.
Matrix3 mean_deformation_gradient(const HexahedronPositions& x, double edge);

/// C = F^T F of that.
tissue::SymmetricTensor right_cauchy_green(const HexahedronPositions& x, double edge);

/// dC/dt of it, v the nodes' velocities [m/s].
tissue::SymmetricTensor right_cauchy_green_rate(const HexahedronPositions& x,
                                                const HexahedronPositions& v,
                                                double edge);

/// Forces on the nodes [N], of the strands' S and the volume stress v:
///
///     f_a = sum w h t d over the springs at a - h^3 v cof F G_a
///
/// A spring pulls along the current d between its ends, w = 1/4, 1/2, 1 for edges, face
/// and inner diagonals, which 4, 2 and 1 cells share; with S_m = tr S/3 its t [Pa] is
///
///     edges along j      11/35 S_m + S_jj - S_m
///     face diagonals     3/35 S_m + S_jk/2 along e_j + e_k, - S_jk/2 along e_j - e_k
///     inner diagonals    3/35 S_m
///
/// so that sum w t r r^T over a cell's springs is h^2 S. S_m is shared as 11/3 : 1 : 1,
/// the ratio of the lattice of A = 1 (shear_modulus_form): at rest, under the tension
/// sum M_i, it is what resists hourglasses. G_a = (+-1, +-1, +-1)/(4h) is the derivative
/// of F by x_a.
///
/// No net force and no torque in any state. In a homogeneous deformation it is
/// - h^3 F S G_a with the whole S of second_piola_kirchhoff.
///
/// Source: own; the volume force after Golec 2018, Eq. 5.17.
HexahedronPositions tissue_forces(const HexahedronPositions& x, double edge,
                                  const tissue::PointStress& stress);

/// Minus their derivative by the positions, the stress following C by `tangent` [N/m].
/// Symmetric in homogeneous states; elsewhere the springs' pull is not quite that of an
/// energy, as their tensions follow the mean C alone.
Matrix24 tissue_stiffness(const HexahedronPositions& x, double edge,
                          const tissue::PointStress& stress,
                          const tissue::PointTangent& tangent);

}  // namespace springcheck::mss
