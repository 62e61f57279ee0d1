#pragma once

#include "meshing/loads/scene.hpp"

namespace springcheck::mss {

/// Spring constants of a cubic lattice [N/m]: one edge, face-diagonal and
/// inner-diagonal spring each stand for all the cells that share it (4, 2 and 1).
struct LatticeStiffness {
  double edge;
  double face_diagonal;
  double inner_diagonal;
};

/// Everything a lattice's law is made of.
struct LatticeConstants {
  LatticeStiffness stiffness;
  double volume_modulus;  // kappa [Pa] of the volume correction; 0 without
};

/// Lattice that reproduces the shear modulus for every Poisson ratio:
///
///     k_c = 3 mu h / (3A + 4)     k_f = A k_c     k_e = k_f + (8/3) k_c
///
/// shear_modulus   mu [Pa]
/// cell_edge       h  [m]
/// diagonal_ratio  A = k_f/k_c >= 0; 0 leaves the face diagonals out
///
/// Alone it has lambda = mu (nu = 1/4); the volume correction supplies the rest.
/// Source: Golec 2018, Eq. 5.11 and the mu-forms of Eq. 5.12.
LatticeStiffness shear_modulus_form(double shear_modulus, double cell_edge,
                                    double diagonal_ratio);

/// The forms of Golec 2018, Eq. 5.12, in Young's modulus: mu = 2E/5 put into
/// shear_modulus_form. Right at nu = 1/4 only; with the volume correction of another nu
/// the material is wrong (nu = 0: E_eff = 2E/3, nu_eff = -1/6). Offered because the
/// printed nu = 0 rows of Table 5.1 were computed so.
LatticeStiffness young_modulus_form(double young_modulus, double cell_edge,
                                    double diagonal_ratio);

/// Baudet's system, edges and inner diagonals only, no volume correction. Per cell
///
///     k_ed = E h (4 nu + 1) / (8 (1 + nu))     k_d = 3 E h / (8 (1 + nu))
///
/// and a lattice edge is four cells' k_ed. Valid for nu in (-1/4, 1/2); identical to
/// shear_modulus_form with A = 0 at nu = 1/4. Source: Golec 2018, chapter 3 after Baudet.
LatticeStiffness baudet_stiffness(double young_modulus, double poisson_ratio,
                                  double cell_edge);

/// What one tetrahedron adds to its edge of length l [N/m], and no more than that: the
/// sum over the tetrahedra at an edge is its spring.
///
///     Van Gelder  k = E V/l^2        V its volume [m^3]
///     Lloyd       k = 2 sqrt(2)/25 l E
///
/// No isotropic material comes of them but in special meshes, and none of a chosen
/// Poisson ratio. Source: Van Gelder, Approximate simulation of elastic membranes by
/// triangulated spring meshes (1998); Lloyd, Szekely and Harders, Identification of
/// spring parameters for deformable object simulation (2007), whose tetrahedra are
/// regular.
double van_gelder_stiffness(double young_modulus, double volume, double length);
double lloyd_stiffness(double young_modulus, double length);

/// Modulus of the volume correction [Pa], W = kappa/2 (V - V0)^2 / V0 per cell:
///
///     kappa = E (4 nu - 1) / (2 (1 + nu)(1 - 2 nu)) = lambda - mu
///
/// Negative below nu = 1/4, zero at it. Source: Golec 2018, Eq. 5.36.
double volume_correction_modulus(const Material& material);

}  // namespace springcheck::mss
