#pragma once

#include <vector>

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// How time and memory grow with the cells of cubes: of explicit steps, and of static
/// solutions with direct and iterative linear solvers, by springs and finite elements,
/// each with exponents fitted over its sizes. Direct solvers' factors grow faster than
/// bodies, and have sizes of their own. Measured on one thread, one body at a time; no
/// case is behind it, and no two runs give the same digits. Sizes that need more memory
/// than is left, that are expected to take more than `most_seconds`, by the growth of the
/// series so far, or whose solution fails are named in the notes.
Table growth_table(const std::vector<int>& across,
                   const std::vector<int>& across_directly, double most_seconds = 900);

/// The plan of the growth table of 10^3, 10^4, 10^5 and 10^6 cells, about, and for direct
/// solvers up to 2 10^4; it is measured while the table is made.
TablePlan plan_growth_table();

}  // namespace springcheck
