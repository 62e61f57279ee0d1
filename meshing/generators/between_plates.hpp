#pragma once

#include <string>

#include "meshing/mesh_parts.hpp"

namespace springcheck {

/// The mesh of a body that stands between plates at z = 0 and z = height [m], with the
/// regions bottom, top and surface (the rest), in the order of a Z-curve. `unit` is the
/// length [m] of 1 in the parts, whose nodes may lie off the plates by 1e-6 of the
/// height.
///
/// Throws InputError for what Mesh refuses.
Mesh mesh_between_plates(const std::string& source, const MeshParts& parts, double unit,
                         double height);

}  // namespace springcheck
