#pragma once

#include <vector>

#include "comparisons/cases/method.hpp"

namespace springcheck {

/// Finite elements that step explicitly.
std::vector<Method> explicit_element_methods();

}  // namespace springcheck
