#pragma once

#include <array>

#include "mss/networks/network.hpp"

namespace springcheck::mss {

using Matrix3c = Eigen::Matrix3cd;

/// How a node of the infinite lattice is coupled with those n cells away, n in
/// {-1, 0, 1}^3, in the homogeneous state x = F X:
///
///     C_n = sum of K_ab over the corners a, b of a cell with X_b - X_a = h n   [N/m]
///
/// K the second derivatives of a cell's energy (tangent_at). C_-n = C_n^T.
///
/// cell: one cube of the lattice as a network of its own, whose springs are what it adds
/// to the lattice's. For methods whose cells share nothing but nodes; not for mss-affine
/// above nu = 1/4, whose volume correction reaches over the neighbours.
struct Couplings {
  std::array<Matrix3, 27> blocks{};  // C_n at 9 (n_z + 1) + 3 (n_y + 1) + n_x + 1
  double edge;                       // h [m]
};
Couplings couplings(const Network& cell, const Matrix3& deformation_gradient);

/// The dynamical matrix of the plane waves u_a = p exp(i q . X_a), whose energy per cell
/// is 1/2 p* D p:
///
///     D(q) = sum over n of C_n exp(i t . n),   t = h q   [N/m]
///
/// It is Hermitian, with D(-q) = conj D(q), and of period 2 pi in each component of t.
/// phases: t [rad per cell], q on the undeformed lattice.
/// Source: Born and Huang, Dynamical Theory of Crystal Lattices (1954), section 24.
Matrix3c dynamical_matrix(const Couplings& lattice, const Vector3& phases);

/// What is left of D for long waves along the unit vector m [Pa]:
///
///     Q = lim D(q)/(h^3 |q|^2) = -1/(2h) sum over n of C_n (m . n)^2
///
/// the acoustic tensor Q_ik = m_J (dP_iJ/dF_kL) m_L of the lattice's continuum.
Matrix3 acoustic_tensor(const Couplings& lattice, const Vector3& direction);

/// A wave and the modulus it meets.
struct LatticeWave {
  Vector3 phases;  // t = h q [rad per cell]; of long waves only the direction counts
  double modulus;  // [Pa], see wave_modulus
};

/// Phases below which a wave is taken for infinitely long: there 1e-16 of D's terms are
/// 1e-10 of the modulus.
inline constexpr double long_wave = 1e-3;  // [rad per cell]

/// Lowest modulus over the polarisations p of a wave:
///
///     lowest eigenvalue of D(q)/(4 h sum_i sin^2(t_i/2))   [Pa]
///
/// and of Q for long waves, its limit. The divisor is h^3 |q|^2 for long waves and, like
/// D, periodic: the modulus neither vanishes near q = 0 nor jumps at the zone's boundary.
/// phases: not zero.
double wave_modulus(const Couplings& lattice, const Vector3& phases);

/// |C_0|/h [Pa], of the order of the largest modulus: what rounding is measured in.
double largest_modulus(const Couplings& lattice);

/// The wave of the lowest modulus, by a grid over half the Brillouin zone and over the
/// directions of long waves, and descent from its lowest points. Where the modulus is
/// negative, the state is unstable whatever holds the body's surface. A long wave is
/// named where none is lower by more than rounding.
LatticeWave softest_wave(const Couplings& lattice);

/// 2 pi/|t|, in cells of the undeformed lattice; infinite for long waves.
double wavelength(const LatticeWave& wave);

}  // namespace springcheck::mss
