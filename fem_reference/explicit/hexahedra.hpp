#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>

#include "meshing/mesh.hpp"

namespace springcheck::fem_reference {

/// Vectors of a hexahedron's corners as columns, in the order of grid_corners. Corner x +
/// 2 y + 4 z, each 0 or 1, is at xi = (2 x - 1, 2 y - 1, 2 z - 1) of the cube that is
/// mapped to the cell.
using CornerVectors = Eigen::Matrix<double, 3, 8>;

CornerVectors corner_vectors(const CellNodes& hexahedron, std::span<const Vector3> of);

/// The trilinear functions on the cube are spanned by eight products of its coordinates:
/// mode s is the product of those xi_k whose bit k is set in s, from 1 (0) to xi eta zeta
/// (7). Its value at a corner is 1 or -1. The products of two and three are the hourglass
/// modes.
double mode(std::size_t s, const Vector3& xi);
Vector3 mode_gradient(std::size_t s, const Vector3& xi);  // by xi
Vector3 corner_place(std::size_t corner);                 // its xi
inline constexpr std::array<std::size_t, 4> hourglass_modes{3, 5, 6, 7};

/// One of the 2 x 2 x 2 Gauss points, numbered like the corners, which stand around them.
struct GaussPoint {
  double volume;                     // det J, the weight being 1 [m^3]
  Eigen::Matrix3d inverse_jacobian;  // d xi_k/d X_j [1/m], row k
};
Vector3 gauss_place(std::size_t point);  // its xi
std::array<GaussPoint, 8> gauss_points(const CornerVectors& rest);

/// Gradients of the shape functions at a Gauss point as columns [1/m]:
/// dN_a/dX = J^-T dN_a/d xi, N_a the mean of the modes, each with its sign at a.
CornerVectors shape_gradients(const GaussPoint& at, std::size_t point);

/// What the element of one point knows of a cell.
///
/// The mean gradient of a field u is H = sum_a u_a (x) B_a with
///
///     B_a = dV/dX_a / V
///
/// V the exact volume. What of the field is not linear is seen by
///
///     q_s = sum_a gamma_sa u_a,  gamma_sa = [phi_s(a) - B_a . sum_b phi_s(b) X_b]/8
///
/// s an hourglass mode and phi_s(a) its sign at a corner: 0 for linear fields, and
/// on a parallelepiped the mode's amplitude. It is held by the energy
///
///     W_hg = mu/2 sum_s k_s |q_s|^2,   k_s = int |d phi_s/dX|^2 dV
///
/// by 2 x 2 x 2 points: mu/2 times the square of the gradient of each mode. |q_s| does
/// not change when the body turns, so that W_hg is the same in any frame, at any rotation
/// and strain. On a cube of edge h, k_s = 8/3 h for two coordinates. For eta zeta along
/// x, which shears, that is exact. For xi eta along x or y, which bend, it is 1/(1 + nu)
/// of the stiffness 4/3 E h of a beam in pure bending, without the shear by which full
/// integration locks. Torsion about z, eta zeta along -x and xi zeta along y at once, it
/// makes twice too stiff, a part of the cell's energy that vanishes under refinement. It
/// is free of lambda and does not lock near nu = 1/2. In cells longer than wide the mean
/// of the directions counts, and bending along them is too stiff, as with full
/// integration.
///
/// Measured against fem-stvk q1-sri: torque of a cube of 6^3 cells + 3.1 to 3.4 %, 10^3
/// + 1.2 to 1.5 % (nu = 0 to .499, 1 degree; at 45 degrees + 2.0 to 2.3 and + .7 to .9).
/// Small drop of the tip of a 1:6 beam of 2 x 2 x 12 cells + 3.5 to 6.6 %, of 4 x 4 x 24
/// + 1.0 to 1.7 % (nu = 0 to .45), where q2 gives + 1.0 to 3.9 and + .7 to 1.1. Half of
/// k_s would make the torque of 10^3 cells right to .5 % and the beams' tips 18 and 4 %
/// too soft.
///
/// Source: B, gamma and the form of the energy: Flanagan and Belytschko 1981, A uniform
/// strain hexahedron and quadrilateral with orthogonal hourglass control, International
/// Journal for Numerical Methods in Engineering 17, 679-706. Their stiffness is a free
/// coefficient times V (lambda + 2 mu) sum_a |B_a|^2; k_s is ours, on a cube
/// 16/9 V sum_a |B_a|^2.
struct OnePointCell {
  double volume;                                   // V [m^3]
  CornerVectors gradients;                         // B_a as columns [1/m]
  Eigen::Matrix<double, 4, 8> hourglass_shapes;    // gamma [-]
  Eigen::Matrix<double, 3, 4> hourglass_position;  // sum_b phi_s(b) X_b as columns [m]
  Eigen::Vector4d hourglass_stiffness;             // k_s [m]
};
OnePointCell one_point_cell(const CornerVectors& rest);

/// Volumes that the corners stand for, int N_a dV, by 2 x 2 x 2 points, which are exact:
/// N_a det J is of third degree in each coordinate. Times the density, the row sums of
/// the consistent mass matrix [m^3].
std::array<double, 8> corner_volumes(const CornerVectors& rest);

}  // namespace springcheck::fem_reference
