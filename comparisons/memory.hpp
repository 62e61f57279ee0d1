#pragma once

#include "comparisons/study.hpp"

namespace springcheck {

/// Estimated peak memory of the program with one mesh of that size [bytes].
double estimated_mesh_memory(const BlockSize& block);

/// Estimated peak memory of one simulation [bytes], from its method, solver and cell
/// counts; see the source for the measurements behind it. Within a factor of two for
/// blocks of 10^3 cells and more.
double estimated_memory(const CaseSettings& settings);

/// Memory this machine can still give [bytes]: what Linux calls available.
double available_memory();

/// Throws InputError when the mesh alone would not fit into the available memory.
/// `place` says where the cell counts were given.
void check_mesh_memory(const std::string& place, const BlockSize& block);

/// Throws InputError when `parallel` of the requests at once, references included, would
/// not fit into the available memory. Allocates nothing itself.
void check_memory(const std::string& place, const std::vector<Request>& requests,
                  int parallel);

}  // namespace springcheck
