#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Lowest natural frequencies of the free cube and of the cantilever: springs against
/// finite elements and theory, with no simulation of a scene behind them.
TablePlan plan_modes_table();

}  // namespace springcheck
