#pragma once

#include <span>
#include <string>

#include "dynamics/marching/march.hpp"

// What a march looks at before it begins, and on its way.
namespace springcheck::dynamics {

/// Length of the box around the nodes from corner to corner [m].
double body_size(const std::vector<Vector3>& nodes);

/// The longest of the vectors; infinite if any of them is not finite.
double longest(const std::vector<Vector3>& vectors);

/// How far velocities have turned round in a step [-], of -1 to 1:
///
///     -sum m v . v' / (sum m (v.v + v'.v')/2)
///
/// The step of symplectic schemes leaves the unit circle at z = -1: what then grows is
/// reversed by every step. 1 is a motion that consists of nothing else; from 1/2 on it
/// has three quarters of the kinetic energy.
double alternation(std::span<const double> masses, const std::vector<Vector3>& before,
                   const std::vector<Vector3>& now);

/// Why the march does not begin, if it does not. limit: at rest [s].
std::string reason_to_refuse(const MarchedBody& body, const Protocol& protocol,
                             double limit, bool is_anything_free);

/// "dt = 0.001 s is above the limit 0.0009 s of the strained body from step 7 on". An
/// open step is so only there, and then shortened.
std::string above_limit(const MarchedBody& body, const Protocol& protocol,
                        const Excess& excess);

}  // namespace springcheck::dynamics
