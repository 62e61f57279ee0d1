#pragma once

#include "meshing/cell_geometry.hpp"
#include "mss/networks/deformation.hpp"
#include "tissue/memory.hpp"

// A cell of living tissue, of any type: what it remembers acts in its mean deformation,
// and is carried by springs without rest length between its nodes and by the volume force
// of Golec 2018, Eq. 5.17.

namespace springcheck::mss {

/// What forces need of a cell's shape at rest. Cells that are translations of each other
/// have the same.
struct TissueShape {
  double volume;              // V [m^3]
  CornerPositions gradients;  // G_a = B_a/V [1/m], B_a = cell_volume_gradient
  // The projection P of the nodes' positions on what of them is not affine, P x: it is
  // symmetric, P = P P. Tetrahedra have none.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 8, 8> hourglasses;
};

TissueShape tissue_shape(const CornerPositions& rest);

/// V^(1/3)/2 [m], see tissue_forces.
double hourglass_length(double volume);

/// F = sum x_a (x) G_a, the cell's mean deformation gradient.
/// Source: Golec 2018, Eq. 5.18, for cubes.
Matrix3 mean_deformation_gradient(const TissueShape& shape, const CornerPositions& x);

/// C = F^T F of that.
tissue::SymmetricTensor right_cauchy_green(const TissueShape& shape,
                                           const CornerPositions& x);

/// dC/dt, with v the nodes' velocities [m/s].
tissue::SymmetricTensor right_cauchy_green_rate(const TissueShape& shape,
                                                const CornerPositions& x,
                                                const CornerPositions& v);

/// Forces on the nodes [N], of the strands' S and the volume stress v:
///
///     f_a = sum_b w_ab (x_b - x_a) - V v cof F G_a
///     w_ab = - V G_a . S G_b - c P_ab,   c = V^(1/3)/2 S_m,   S_m = tr S/3
///
/// Between every two nodes is a spring of no rest length, of the stiffness w_ab. The
/// springs' sum is - V F S G_a - c P_ab x_b: the first alone is what a homogeneous cell
/// has of S, and leaves hourglasses free; the second, which is nothing in affine states,
/// resists them. In a cube whose edges bend as a beam of E = 3 S_m the energy is S_m h/4
/// for each unit of P x: at rest, under the tension S_m = sum M_i, that is tissue's E
/// near nu = 1/2.
///
/// The forces have no net force and no torque in any state. In a homogeneous deformation
/// they are - V F S G_a with the whole S of second_piola_kirchhoff.
///
/// Source: own; the volume force after Golec 2018, Eq. 5.17, the projection after
/// Flanagan and Belytschko, Int. J. Numer. Methods Eng. 17 (1981) 679.
CornerPositions tissue_forces(const TissueShape& shape, const CornerPositions& x,
                              const tissue::PointStress& stress);

/// A matrix on the positions stacked column by column.
using TissueStiffness = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 24, 24>;

/// Minus the derivative of tissue_forces by the positions, the stress following C by
/// `tangent` [N/m]. It is symmetric in homogeneous states; elsewhere the springs' pull is
/// not quite that of an energy, as their stiffness follows the mean C alone.
TissueStiffness tissue_stiffness(const TissueShape& shape, const CornerPositions& x,
                                 const tissue::PointStress& stress,
                                 const tissue::PointTangent& tangent);

}  // namespace springcheck::mss
