#pragma once

#include <string>

namespace springcheck {

/// Version of the gmsh library in use, such as "4.8.4".
std::string gmsh_version();

}  // namespace springcheck
