#pragma once

#include "comparisons/study.hpp"

namespace springcheck {

/// Throws InputError when the mesh alone would not fit into the memory that is available
/// (what Linux calls so).
/// `place` says where the cell counts were given.
void check_mesh_memory(const std::string& place, const BlockSize& block);

/// Throws InputError when `parallel` of the requests at once, references included, would
/// not fit into the available memory. Allocates nothing itself.
void check_memory(const std::string& place, const std::vector<Request>& requests,
                  int parallel);

}  // namespace springcheck
