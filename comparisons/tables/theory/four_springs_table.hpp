#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Golec's four springs: the force of his figure 3.2 against extension, and the loop
/// under a load that grows and goes back.
TablePlan plan_four_springs_table();

}  // namespace springcheck
