#pragma once

#include <filesystem>
#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck {

/// Displacements [m] of the mesh's nodes from a VTK file: an UnstructuredGrid of one
/// Piece whose points are the undeformed nodes [m], in any order and to 1e-6 of the
/// smallest edge (and the rounding of 32-bit numbers), with the displacement in
/// PointData: the array of that name, or else the only one of three components. Arrays
/// are ascii or inline base64 (format "binary"), uncompressed or compressed by zlib;
/// cells are not read. Throws InputError for anything else.
std::vector<Vector3> read_vtu_displacements(const std::filesystem::path& file,
                                            const Mesh& mesh);

}  // namespace springcheck
