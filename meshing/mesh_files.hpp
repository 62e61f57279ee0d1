#pragma once

#include <filesystem>

#include "meshing/mesh.hpp"

namespace springcheck {

/// Writes the mesh in the format its extension names: .msh (gmsh 4.1), .vtu (VTK
/// unstructured grid, ASCII, coordinates that read back exactly) or .inp (CalculiX:
/// *NODE, *ELEMENT of type C3D8 in the set Eall, one *NSET per region).
///
/// The file appears whole or not at all. Throws InputError for another extension,
/// std::runtime_error when not all could be written.
void write_mesh(const Mesh& mesh, const std::filesystem::path& file);

}  // namespace springcheck
