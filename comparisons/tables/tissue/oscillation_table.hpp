#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// G' and G'' of liver, kidney and spleen from 0.1 to 100 rad/s: by the bi-power law, by
/// the Maxwell branches fitted to it, and by mss-tissue, two cases each, which end after
/// 10 1/4 cycles of a small oscillation, where the load is largest, and after 10.
TablePlan plan_tissue_oscillation_table();

}  // namespace springcheck
