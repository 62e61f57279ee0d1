#pragma once

namespace springcheck::fem_reference {

/// Constitutive laws; formulas and sources in materials.hpp.
enum class Law { hooke, st_venant_kirchhoff, hencky, cauchy_born };

/// Elements, named by what they are on a hexahedron.
///
///     q1      the nodes of the cell: trilinear on a hexahedron, linear on a tetrahedron,
///             in between on prisms and pyramids (cell_shapes.hpp); locks near nu = 1/2
///     q1_sri  the same, the volumetric part of the law from the cell's mean dilatation
///             (cell.hpp): does not lock on hexahedra; on tetrahedra the same as q1
///     q1_nodal  the same, the volumetric part from the mean dilatation around each node,
///             on tetrahedra the rest of the law from the mean gradient around each node
///             (nodal_patch_state.hpp): does not lock on cells of any type
///     q2      triquadratic (27 nodes), 3x3x3 Gauss points; hexahedra only
enum class Element { q1, q1_sri, q1_nodal, q2 };

/// Springs whose continuum the law cauchy_born is (cauchy_born.hpp).
enum class Springs { baudet, nfd, fd, cf, affine };

/// Modulus that the spring constants are computed from, as in the network they mirror.
enum class SpringConstants { from_shear_modulus, from_young_modulus };

/// Strain that the springs' energy is quadratic in, and with it their volume
/// correction's; hencky is a function of another kind (cauchy_born.hpp).
enum class SpringStrain { engineering, green, logarithmic, hencky };

/// Direction of the lattice that lies along the body's z axis.
enum class LatticeDirection { d100, d110, d111 };

struct Lattice {
  Springs springs = Springs::cf;
  double diagonal_ratio = 1;  // A = k_f/k_c of fd and cf
  SpringConstants constants = SpringConstants::from_shear_modulus;
  LatticeDirection direction = LatticeDirection::d100;
  SpringStrain strain = SpringStrain::engineering;
  int axes = 6;  // of affine: 6, 16 or 25
};

struct Settings {
  Law law;
  Element element;
  Lattice lattice{};  // read by cauchy_born
};

}  // namespace springcheck::fem_reference
