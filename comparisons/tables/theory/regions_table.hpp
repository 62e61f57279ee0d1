#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Borders of the integrators' stability regions, of Golec 2018, figures 2.2 and 2.3, and
/// in the plane of omega dt and zeta: found by stepping, beside those on paper.
TablePlan plan_regions_table();

}  // namespace springcheck
