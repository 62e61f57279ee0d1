#pragma once

#include <vector>

#include "comparisons/cases/method.hpp"

namespace springcheck {

/// Elastic springs; constants, networks and what they cover: mss/networks.
std::vector<Method> spring_methods();

}  // namespace springcheck
