#pragma once

#include <filesystem>

#include "meshing/mesh.hpp"

namespace springcheck {

/// Reads anybody's mesh from a .msh file of gmsh, version 2.2 or 4.1, ASCII or binary,
/// of tetrahedra, pyramids, prisms and hexahedra of first order. Where there are physical
/// volumes, only cells in them count; several are one material, which is warned of.
/// Physical surfaces become regions by their names, or their numbers where they have
/// none; of those that are inside the body, if only in part, the names are kept. Nodes
/// that cells use keep the order of their numbers in the file; others, as of lines and
/// points alone, are left out.
///
/// metres_per_unit  of the file's coordinates [m], such as 0.001 for millimetres
///
/// Throws InputError, in the file's own numbers, for a file that cannot be read, is not
/// of these formats, is damaged or partitioned, has elements of higher order, or has no
/// cells; for cells that are turned over, flat or there twice; for nodes that no element
/// uses or that do not exist; for physical surfaces that have a face twice; and for what
/// check_conformity refuses.
Mesh read_msh(const std::filesystem::path& file, double metres_per_unit);

}  // namespace springcheck
