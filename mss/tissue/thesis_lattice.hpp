#pragma once

#include "mss/networks/stiffness.hpp"
#include "tissue/thesis_spring.hpp"

namespace springcheck::mss {

/// Springs of Eq. 4.4 on the cubic lattice of the thesis's method.
struct ThesisTissue {
  tissue::ThesisSpring spring;
  LatticeStiffness stiffness;  // k of edges, face and inner diagonals [N/m]
  double cell_edge;            // h [m]
};

/// The tissue of chapter 4 in cells of edge h [m]: constants of shear_modulus_form with
/// A = 1, E the number of K ("the consistency K is used as a reference point to assign
/// Young's modulus") and nu = 0.499, mu = E/(2 (1+nu)).
///
/// Source: Golec 2018, section 4.4, which names E, nu and the mesh of section 5.3 but not
/// the constants; section 4.5 says they were chapter 3's, without face diagonals. This
/// reading is ours.
ThesisTissue thesis_tissue(const tissue::BipowerLaw& law, double hand_fitted_limit,
                           tissue::Elongation elongation, double cell_edge);

/// Shear stress sigma_xz [Pa] of the lattice in homogeneous simple shear gamma, without
/// the dashpots, for which the thesis has no constant:
///
///     sigma_xz = (1/h^3) sum over a cell's springs of T d_x d_z/|d|,   d = F r
///
/// Its volume is kept: the volume correction is silent. Source: the virial stress, J = 1.
double shear_stress(const ThesisTissue& lattice, double strain);

}  // namespace springcheck::mss
