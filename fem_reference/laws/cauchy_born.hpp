#pragma once

#include <vector>

#include "fem_reference/laws/dilatation.hpp"
#include "fem_reference/laws/settings.hpp"
#include "meshing/scene.hpp"

namespace springcheck::fem_reference {

/// A direction of a lattice's springs: all springs of stiffness k and rest length l along
/// n, one in each volume V, weigh w = k l^2/V.
struct SpringDirection {
  Eigen::Vector3d direction;  // n, a unit vector
  double weight;              // w [Pa]
};

/// The continuum that a spring lattice with volume correction converges to (the
/// Cauchy-Born rule: springs follow F):
///
///     psi = sum w/2 (|F n| - 1)^2 + U(t),   t = J - 1,   U = kappa/2 t^2
///     P = sum w (1 - 1/|d|) d (x) n,   d = F n   (shape part)
///     dP_iJ/dF_kL = sum w [(1 - 1/|d|) delta_ik + d_i d_k/|d|^3] n_J n_L
///
/// Validity: any F with no spring of zero length.
/// Source: Born and Huang, Dynamical Theory of Crystal Lattices (1954); the
/// energy is the mss-cf cell's (Golec 2018, chapter 5) with lattice values of k over h^3.
struct CauchyBorn {
  std::vector<SpringDirection> springs{};
  double volume_modulus;  // kappa [Pa]

  /// The springs' part of psi [Pa], its stress and its tangent dP/dF.
  [[nodiscard]] double energy(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix3 stress(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix9 tangent(const Matrix3& displacement_gradient) const;

  [[nodiscard]] static Dilatation dilatation(const Matrix3& displacement_gradient);
  [[nodiscard]] VolumetricEnergy volumetric_energy(double dilatation) const;
};

/// Rotation from the lattice's frame to the body's; its rows are the body's axes in the
/// lattice's frame.
Matrix3 lattice_to_body(LatticeDirection direction);

/// Weights w of the lattices [Pa], h having dropped out:
///
///     cf, fd    edges (3)             (3A + 8) mu/(3A + 4)
///               face diagonals (6)    6 A mu/(3A + 4)
///               inner diagonals (4)   9 mu/(3A + 4)
///     nfd       the same with A = 0
///     baudet    edges (3)             E (4 nu + 1)/(2 (1 + nu))
///               inner diagonals (4)   9 E/(8 (1 + nu))
///     affine    icosahedron's axes (6), (phi, +-1, 0) and cyclic   5 mu/2
///
/// kappa = lambda - mu; 0 for baudet and fd. With SpringConstants::from_young_modulus mu
/// is 2E/5 in the weights, as Golec 2018, Eq. 5.12 prints them.
/// Source: Golec 2018, Eq. 5.11 and 5.12 (k over h^3, times the squared length).
CauchyBorn cauchy_born(const Material& material, const Lattice& lattice);

}  // namespace springcheck::fem_reference
