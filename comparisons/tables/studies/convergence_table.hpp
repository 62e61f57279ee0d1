#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Errors of springs and finite elements in shearing at a deformation of 1e-5, on 2, 4, 8
/// and 16 cells across, by type of cells, with fitted orders.
TablePlan plan_convergence_table();

}  // namespace springcheck
