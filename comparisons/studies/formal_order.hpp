#pragma once

#include "comparisons/cases/case.hpp"

namespace springcheck {

/// Exponent a of the displacements r^a, r the distance from the edge where a glued plate
/// ends and a free face begins at a right angle: the root in (0, 1] of
///
///     k sin^2(a pi/2) = (1 + k)^2/4 - a^2,   k = 3 - 4 nu
///
/// of plane strain; 1 for nu <= 0, where stresses are bounded. nu below 1/2.
///
/// Source: M. L. Williams, "Stress singularities resulting from various boundary
/// conditions in angular corners of plates in extension", J. Appl. Mech. 19, 1952,
/// 526-528, clamped and free edges.
double clamped_edge_exponent(double nu);

/// The smallest order that such edges leave: twice the exponent at nu = 1/2.
inline constexpr double least_formal_order = 1.189;

/// Order with which errors of forces, volumes and displacements fall at last as a case's
/// grid is refined: that of the element or of the springs, for displacements in the mean
/// where the solution is smooth, but no more than 2 a where a glued plate ends
/// (clamped_edge_exponent): errors of the energy, and of functionals, fall as its square.
/// Free faces of other bodies than blocks meet their plates at any angle: there 1, that
/// of a plate that ends on a flat face.
///
/// Of isotropic linear elasticity, and of edges: the points in which edges meet are left
/// out, and what large strain makes of either. By q1-sri on 5 to 20 cells, Hencky's law
/// compressed by 20 % shows .97 (nu = .25) and .86 (.45) where this is 1.49 and 1.24.
///
/// Source: G. Strang, G. J. Fix, "An Analysis of the Finite Element Method", 1973, of
/// smooth solutions and of singularities.
double formal_order(const CaseSettings& settings);

}  // namespace springcheck
