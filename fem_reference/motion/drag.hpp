#pragma once

#include <span>
#include <vector>

#include "meshing/loads/scene.hpp"

namespace springcheck::fem_reference {

/// Rate of the drag -alpha m v on every node [1/s]:
///
///     alpha = 2 zeta omega,   omega = pi c_s/L,   c_s = sqrt(mu/rho)
///
/// L the longest extent of the mesh along an axis. A body held at one end shears in its
/// slowest standing wave at pi c_s/(2 L), held at both at omega: swings of frequency
/// omega are damped by zeta of critical, faster ones less. The drag also acts on rigid
/// motions. Source: mass-proportional part of Rayleigh damping.
double drag_rate(const Mesh& mesh, const Material& material, double damping_ratio);

/// Forces on the nodes with that drag [N], one per node as masses and velocities.
std::vector<Vector3> with_drag(std::vector<Vector3> forces, double rate,
                               std::span<const double> masses,
                               std::span<const Vector3> velocities);

}  // namespace springcheck::fem_reference
