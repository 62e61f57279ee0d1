#pragma once

#include "comparisons/study.hpp"

namespace springcheck {

/// Estimated peak memory of one simulation [bytes], from its method, solver and cell
/// counts; see the source for the measurements behind it. Meant to be within a factor of
/// two for blocks of 10^3 cells and more.
double estimated_memory(const CaseSettings& settings);

/// Memory this machine can still give [bytes]: what Linux calls available.
double available_memory();

/// Throws InputError when `parallel` of the requests at once, references included, would
/// not fit into the available memory. Allocates nothing itself.
void check_memory(const std::vector<Request>& requests, int parallel);

}  // namespace springcheck
