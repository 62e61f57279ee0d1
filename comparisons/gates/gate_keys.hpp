#pragma once

#include <vector>

#include "comparisons/cases/described.hpp"

namespace springcheck::gates {

/// Every key of a [[gate]], and what it means.
const std::vector<Described>& gate_keys();

}  // namespace springcheck::gates
