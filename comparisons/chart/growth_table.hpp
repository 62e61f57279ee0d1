#pragma once

#include "comparisons/sheet.hpp"

namespace springcheck {

/// How time and memory grow with the cells, from 10^3 to 10^6 of them: of explicit steps,
/// and of static solutions with direct and iterative linear solvers, by springs and
/// finite elements, each with exponents fitted over its sizes. Measured while the table
/// is made, on one thread, one body at a time; no case is behind it, and no two runs give
/// the same digits.
SheetPlan plan_growth_table();

}  // namespace springcheck
