#pragma once

#include "meshing/loads/scene.hpp"

namespace springcheck {

/// A prismatic beam of square section, clamped at one end, free at the other.
struct SquareCantilever {
  double length;  // L [m]
  double edge;    // a of the section [m]; area A = a^2, I = a^4/12
  Material material;
};

/// Natural frequencies [Hz] of the n-th mode of a kind, n = 1, 2, ...

/// Bending without shear and rotary inertia:
///
///     f = b/(2 pi L^2) sqrt(E I/(rho A)),   1 + cosh(sqrt b) cos(sqrt b) = 0
///
/// Valid for wavelengths far above a. Source: Blevins, Formulas for Natural Frequency and
/// Mode Shape (1979), table 8-1.
double euler_bernoulli_frequency(const SquareCantilever& beam, int n);

/// Bending with both, shear factor k = 5/6: f as above with b the n-th root of
///
///     2 + (b^2 (r^2 - s^2)^2 + 2) cosh(b alpha) cos(b beta)
///       - b (r^2 + s^2)/sqrt(1 - b^2 r^2 s^2) sinh(b alpha) sin(b beta) = 0
///
///     r^2 = I/(A L^2),   s^2 = E I/(k G A L^2)
///     alpha^2, beta^2 = (-+ (r^2 + s^2) + sqrt((r^2 - s^2)^2 + 4/b^2))/2
///
/// Valid up to b r s = 1, the first frequency of shear across the section; throws
/// std::domain_error where there is no n-th root below.
/// Source: Huang, J. Appl. Mech. 28 (1961) 579, fixed-free beam.
double timoshenko_frequency(const SquareCantilever& beam, int n);

/// Saint-Venant's torsion, J = .140577 a^4, polar moment I_p = a^4/6, warping free at the
/// clamp too:
///
///     f = (2n - 1)/(4L) sqrt(G J/(rho I_p))
///
/// Source of J: Timoshenko and Goodier, Theory of Elasticity (1970), section 109.
double torsion_frequency(const SquareCantilever& beam, int n);

/// Stretching of a bar, the section free to contract:
///
///     f = (2n - 1)/(4L) sqrt(E/rho)
double stretching_frequency(const SquareCantilever& beam, int n);

}  // namespace springcheck
