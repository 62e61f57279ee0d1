#pragma once

#include "meshing/mesh_parts.hpp"

namespace springcheck {

/// The same mesh with nodes and cells in the order in which the Z curve passes them:
/// ascending by the interleaved bits of their coordinates, a cell's being its mean node.
///
/// Source: Morton 1966, "A computer oriented geodetic data base".
MeshParts along_z_curve(const MeshParts& parts);

}  // namespace springcheck
