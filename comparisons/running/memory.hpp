#pragma once

#include "comparisons/cases/request.hpp"

namespace springcheck {

/// Peak memory of the program while it runs one simulation [bytes], fitted to measured
/// ones (memory.cpp).
double estimated_memory(const CaseSettings& settings);

/// Whether that is left at the moment (available_memory).
bool fits_in_memory(const CaseSettings& settings);

/// Throws InputError when the mesh alone would not fit into the memory that is available
/// (available_memory).
/// `place` says where the cell counts were given.
void check_mesh_memory(const std::string& place, const Body& body);

/// Throws InputError when one of the requests, references included, would not fit into
/// the available memory, or has a matrix with more entries than the solvers can count.
/// Allocates nothing itself.
void check_memory(const std::string& place, const std::vector<Request>& requests);

/// The same with `available` bytes.
void check_memory(const std::string& place, const std::vector<Request>& requests,
                  double available);

}  // namespace springcheck
