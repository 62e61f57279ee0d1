#pragma once

#include <vector>

namespace springcheck {

/// A cantilever of rectangular section under its own weight, clamped at s = 0.
struct Cantilever {
  double length;           // L [m]
  double width;            // l [m], across the bending plane
  double height;           // h [m], in the bending plane
  double young_modulus;    // E [Pa]
  double shear_modulus;    // G [Pa]
  double load_per_length;  // w = rho g l h [N/m]
};

/// The place to which the section at arc length s of the straight beam goes.
struct BeamPoint {
  double drop;   // along the load [m]
  double axial;  // along the undeformed axis [m]
};

/// Euler-Bernoulli, small deflections, I = l h^3/12:
///
///     y(s) = w/(24 E I) (s^4 - 4 L s^3 + 6 L^2 s^2)
///
/// Source: Golec 2018, Eq. 5.38, with the width it leaves out and y > 0 along the load.
BeamPoint euler_bernoulli(const Cantilever& beam, double s);

/// Timoshenko, small deflections, shear factor 5/6: Euler-Bernoulli plus
///
///     w/(5/6 G l h) (L s - s^2/2)
BeamPoint timoshenko(const Cantilever& beam, double s);

/// The elastica: inextensible, no shear, deflections of any size. The slope theta obeys
///
///     E I theta'' = -w (L - s) cos theta,   theta(0) = 0,   theta'(L) = 0
///
/// and is solved by shooting on theta'(0). `s` is ascending in [0, L]; there is one point
/// for each. Source: equilibrium of the Euler elastica under a constant vertical line
/// load.
std::vector<BeamPoint> elastica(const Cantilever& beam, const std::vector<double>& s);

}  // namespace springcheck
