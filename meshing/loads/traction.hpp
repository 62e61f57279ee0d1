#pragma once

#include <span>
#include <vector>

#include "meshing/loads/scene.hpp"

namespace springcheck {

/// Undeformed area that each node of the mesh stands for in the region [m^2], 0 off it:
///
///     A_a = int N_a dA,   N_a the linear or bilinear shape function of each face
///
/// on quadrilaterals by 2 x 2 Gauss points: exact for plane ones, on warped ones dA is no
/// polynomial.
std::vector<double> nodal_areas(const Mesh& mesh, const Region& region);

/// Consistent nodal forces of the scene's tractions at the full load [N], one per node:
/// A_a times the force per undeformed area. Source: virtual work of a dead load.
std::vector<Vector3> traction_forces(const Mesh& mesh, const Scene& scene);

/// The sum of traction_forces and the weight of the nodes' masses [kg]: the loads of
/// bodies whose mass is lumped [N].
std::vector<Vector3> load_forces(const Mesh& mesh, const Scene& scene,
                                 std::span<const double> masses);

}  // namespace springcheck
