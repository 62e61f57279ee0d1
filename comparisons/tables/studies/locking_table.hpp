#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Volumetric locking: the plate force in compression near nu = 1/2 by element.
TablePlan plan_locking_table();

}  // namespace springcheck
