#pragma once

#include "comparisons/tables/plans/sheet_plan.hpp"

namespace springcheck {

/// Lowest natural frequencies of the free cube and of the cantilever: springs against
/// finite elements and theory, with no simulation of a scene behind them.
SheetPlan plan_modes_table();

}  // namespace springcheck
