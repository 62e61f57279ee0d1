#pragma once

#include <vector>

#include "comparisons/cases/described.hpp"

namespace springcheck {

/// Every measure of for_each_measure, in its order, with its unit and what it is.
const std::vector<Described>& measure_list();

}  // namespace springcheck
