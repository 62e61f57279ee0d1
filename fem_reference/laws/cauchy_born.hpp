#pragma once

#include <vector>

#include "fem_reference/laws/dilatation.hpp"
#include "fem_reference/laws/hencky_springs.hpp"
#include "fem_reference/laws/settings.hpp"
#include "meshing/loads/scene.hpp"

namespace springcheck::fem_reference {

/// The continuum that a spring lattice with volume correction converges to (the
/// Cauchy-Born rule: springs follow F). By the springs' strain s, with l = |d|, d = F n:
///
///     psi = sum w/2 s(l)^2 + U(t)
///
///     engineering  s = l - 1      t = J - 1   U = kappa/2 t^2
///     logarithmic  s = ln l       t = J - 1   U = kappa/2 ln^2 J
///     green        s = n.E n - t/3            E = (F^T F - I)/2
///                                 t = tr E    U = (kappa + sum w/9)/2 t^2
///
///     P = sum w s s' d (x) n/l   (shape part)
///     dP_iJ/dF_kL = sum w [s s'/l delta_ik + (s'^2 + s s'' - s s'/l) d_i d_k/l^2] n_J
///     n_L
///
/// With green the springs' own energy is w/2 (n.E n)^2, of which the part of tr E stands
/// in U, so that elements that take t from a cell's mean take it all: where sum w n n is
/// a multiple of I, as in cubic lattices, sum w (n.E n)^2 = sum w s^2 + sum w/9 t^2. Then
/// P = sum w s d (x) n and dP_iJ/dF_kL = sum w [s delta_ik + d_i d_k] n_J n_L - sum w/9
/// F_iJ F_kL. Lattices whose small-strain tensor is isotropic are St-Venant-Kirchhoff's
/// law.
///
/// With hencky the springs are HenckySprings; U = kappa/2 ln^2 J + G/3 ln^3 J with
/// G = sum w/15, and of virtual springs, whose shape part alone they are,
/// U = (kappa + sum w/9)/2 ln^2 J.
///
/// Validity: any F with no spring of zero length; logarithmic and hencky: det F > 0.
/// Source: Born and Huang, Dynamical Theory of Crystal Lattices (1954); the
/// energy is the mss-cf cell's (Golec 2018, chapter 5) with lattice values of k over h^3.
struct CauchyBorn {
  std::vector<SpringDirection> springs{};
  double volume_modulus;  // kappa [Pa]
  SpringStrain strain = SpringStrain::engineering;
  SpringStretch stretch = SpringStretch::whole;  // read with hencky
  double cubic_modulus = 0;                      // G of hencky's U [Pa]

  /// The springs' part of psi [Pa], its stress and its tangent dP/dF.
  [[nodiscard]] double energy(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix3 stress(const Matrix3& displacement_gradient) const;
  [[nodiscard]] Matrix9 tangent(const Matrix3& displacement_gradient) const;

  [[nodiscard]] Dilatation dilatation(const Matrix3& displacement_gradient) const;
  [[nodiscard]] VolumetricEnergy volumetric_energy(double dilatation) const;

  /// sum w/9 [Pa]: what springs alone oppose to a change of all lengths, as a K.
  [[nodiscard]] double springs_bulk_modulus() const;
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
///     affine    icosahedron's axes (6), (phi, +-1, 0) and cyclic   5 mu/2; of 16 axes
///               25/28 mu, and 27/28 mu of the dodecahedron's (10) dual to it, (0,
///               +-1/phi, phi) and cyclic, (+-1, +-1, 1); of 25 axes 8/21 mu for edges
///               (3), 128/189 mu for face diagonals (6), 81/128 mu for inner diagonals
///               (4) of a cube, 14641/24192 mu for (1, 1, 3) and those like it (12)
///
/// kappa = lambda - mu; 0 for baudet and fd, and with it h. With
/// SpringConstants::from_young_modulus mu is 2E/5 in the weights, as Golec 2018, Eq. 5.12
/// prints them. Source: Golec 2018, Eq. 5.11 and 5.12 (k over h^3, times the squared
/// length).
CauchyBorn cauchy_born(const Material& material, const Lattice& lattice);

}  // namespace springcheck::fem_reference
