#pragma once

#include <string>

#include "meshing/quality.hpp"

namespace springcheck {

/// A table of the mesh's cells by type, and a histogram of their scaled Jacobians.
std::string quality_text(const Quality& quality);

}  // namespace springcheck
