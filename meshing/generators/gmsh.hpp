#pragma once

#include <string>

#include "meshing/generators/block.hpp"

namespace springcheck {

/// Version of the gmsh library in use, such as "4.8.4".
std::string gmsh_version();

}  // namespace springcheck
