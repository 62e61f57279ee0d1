#pragma once

#include <string>

#include "comparisons/tables/computed_tables.hpp"

namespace springcheck {

/// In markdown: how the cases ended, how far mss-cf and fem-hencky are from the printed
/// figures, and which rows are not ok. seconds: that it took.
std::string summary(const ComputedTables& computed, double seconds);

}  // namespace springcheck
