#pragma once

#include <vector>

#include "mss/networks/network.hpp"

namespace springcheck::mss {

/// Golec's smallest system that buckles: C in the middle, A above it and B below, D to
/// its left and E to its right, a spring of stiffness k and rest length l from C to each.
/// D and E are fixed at (-+l, 0), A and B are at (0, +-zeta l), C is free along x:
///
///     W(x, zeta) = k [(l' - l)^2 + x^2],   l'^2 = (zeta l)^2 + x^2
///     F_C = -dW/dx = 2 k x (l/l' - 2)
///     F_A = -(1/2l) dW/dzeta = k zeta l (l/l' - 1)
///
/// Source: Golec 2018, section 3.2.2, Eq. 3.13, 3.14, 3.18. These formulas are what
/// nodal_forces is to give on the network, from which all below is computed.
struct FourSprings {
  double stiffness;  // k [N/m]
  double length;     // l [m]
};

struct FourSpringForces {
  double centre;  // F_C, of the springs on C along x [N]
  double top;     // F_A, of the springs on A upwards and on B downwards [N]
};

/// Nodes A, B, C, D, E at x = 0, zeta = 1, where it is at rest.
Network network_of(const FourSprings& system);

/// The forces with C at x [m]; zeta is negative with A below B.
FourSpringForces forces_at(const FourSprings& system, double x, double zeta);

/// d2W/dx2 of the straight state x = 0 [N/m], from tangent_at; 2 k (2 - 1/|zeta|) on
/// paper. zeta is not 0.
double stiffness_of_centre(const FourSprings& system, double zeta);

/// The zeta > 0 at which the straight state stops pushing C back: 1/2 on paper, and -1/2
/// by symmetry. Bisected to 1e-15.
double bifurcation(const FourSprings& system);

/// The place where C rests while A and B are held at zeta [m], to the right if it goes
/// aside: 0 for |zeta| > 1/2, else l sqrt(1/4 - zeta^2) (Eq. 3.15).
double centre_at_rest(const FourSprings& system, double zeta);

/// A state of rest under a load that presses A down and B up.
struct FourSpringRest {
  double load;  // F [N], the springs' F_A
  double zeta;  // [-]
  double x;     // of C [m]
};

/// The state in which zeta comes to rest under the load when it starts from `zeta` and
/// follows the net force, C at rest all the while: the next minimum of W + 2 F l zeta
/// downhill. Throws std::runtime_error where there is none up to 10 l away.
FourSpringRest rest_under(const FourSprings& system, double load, double zeta);

/// Rests under a load that grows from 0 to steps * load_step, goes back to minus that and
/// forth again, each reached from the one before. Figure 3.2's loop: from zeta = 1/2 it
/// jumps to -3/2 at F = k l/2, and from -1/2 to 3/2 at -k l/2 (the thesis has 1/2 there,
/// where F_A is k l/2; the first jump's mirror image is 3/2).
std::vector<FourSpringRest> hysteresis_loop(const FourSprings& system, double load_step,
                                            int steps);

}  // namespace springcheck::mss
