#pragma once

#include "dynamics/integrators.hpp"

namespace springcheck {

/// The largest modulus of the eigenvalues of a step's matrix on the damped oscillator
/// x'' = -2 zeta omega x' - omega^2 x, whose columns are the steps of unit states (x, v);
/// omega = 1, and a step of explicit, semi-implicit Euler and Verlet goes by
/// dynamics::step, any but Verlet's first. For implicit Euler the matrix is the inverse
/// of explicit Euler's of -dt. Motions stay bounded where the modulus is below 1. `phase`
/// is omega dt, not negative; zeta may have any sign.
double spectral_radius(dynamics::Integrator integrator, double phase,
                       double damping_ratio);

/// The place where a ray of constant zeta leaves the region about the origin, in
/// r = omega dt = |Gamma| dt: up to there steps are stable; with implicit Euler, up to
/// there they are not, and stable beyond (0 where it is stable all the way). It is looked
/// for in steps of 1/100 up to r = 10 and bisected to 1e-12; radii count as 1 up to 1e-12
/// off.
///
/// In the plane of dt Gamma = r (-zeta + i sqrt(1 - zeta^2)), |zeta| <= 1, these are
/// the borders of Golec 2018, figures 2.2 and 2.3.
double region_border(dynamics::Integrator integrator, double damping_ratio);

/// What region_border finds, derived on paper:
///
///     explicit Euler          2 zeta; beyond zeta = 1, 2 (zeta - sqrt(zeta^2 - 1))
///     semi-implicit, Verlet   2 (sqrt(1 + zeta^2) - zeta)
///     implicit Euler          -2 zeta
///
/// and 0 where that is negative, which no r is, or where zeta is, with all but implicit
/// Euler. In the plane of dt Gamma these are the circle of radius 1 about -1; of the
/// circle of radius 2 sqrt(2) about 2 the part to the left of the imaginary axis; and the
/// circle of radius 1 about 1. -1 <= zeta for implicit Euler. Source: the roots of the
/// amplification polynomials in dynamics/marching/stable_step.hpp.
double border_on_paper(dynamics::Integrator integrator, double damping_ratio);

}  // namespace springcheck
