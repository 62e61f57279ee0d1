#pragma once

#include <vector>

#include "comparisons/stability/atlas.hpp"

namespace springcheck {

/// The limits of all methods along the first axis, at each value of the second, see
/// make_atlas.
std::vector<AtlasLimit> limits_of(const Atlas& atlas, const AtlasPlan& plan,
                                  CaseRunner& runner);

}  // namespace springcheck
