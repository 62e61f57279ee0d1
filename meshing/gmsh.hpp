#pragma once

#include <filesystem>
#include <string>

#include "meshing/block.hpp"

namespace springcheck {

/// Version of the gmsh library in use, such as "4.8.4".
std::string gmsh_version();

/// Writes nodes, cells and named regions as gmsh .msh 4.1 (ASCII); node and cell tags
/// are our indices plus one. Throws std::runtime_error when not all could be written.
void write_msh(const Mesh& mesh, const std::filesystem::path& file);

}  // namespace springcheck
