#pragma once

#include <vector>

#include "comparisons/running/case_result.hpp"

namespace springcheck {

/// About how long the requests take on one core, references included and each simulation
/// once [s]; from measured runs of the five tests (cost.cpp), good to a factor of 3.
double estimated_seconds(const std::vector<Request>& requests);

}  // namespace springcheck
