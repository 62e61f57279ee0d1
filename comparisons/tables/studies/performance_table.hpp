#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Time of explicit steps on this machine: the thesis's two timed scenes beside its
/// printed times, and the data of its figures 5.20 to 5.25, real time and user/real ratio
/// against cells and threads; springs beside plain loops. Measured while the table is
/// made, one body at a time; no case is behind it, and no two runs give the same digits.
TablePlan plan_performance_table();

}  // namespace springcheck
