#pragma once

#include <filesystem>

#include "meshing/mesh.hpp"

namespace springcheck {

/// Writes the mesh in the format its extension names:
///
///     .msh  gmsh 4.1, ASCII; read_msh gives the same mesh bit by bit
///     .vtu  VTK unstructured grid, ASCII; coordinates read back exactly
///     .inp  CalculiX: *NODE in the set Nall, *ELEMENT of type C3D4, C3D6 and C3D8, as
///           there are, in Eall, and for each region *NSET and *SURFACE of its name;
///           coordinates to 14 digits or more, which is what fits into the 20 characters
///           that CalculiX reads of a number
///
/// The file appears whole or not at all. Throws InputError for another extension, and for
/// pyramids in a .inp file: CalculiX has none; std::runtime_error when not all could be
/// written.
void write_mesh(const Mesh& mesh, const std::filesystem::path& file);

}  // namespace springcheck
