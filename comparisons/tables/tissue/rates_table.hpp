#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Liver, kidney and spleen in simple shear to 10, 30 and 100 % at rates of 0.001 to
/// 50 1/s: stress by the bi-power law, by the Maxwell branches fitted to it, and by
/// mss-tissue.
TablePlan plan_tissue_rates_table();

}  // namespace springcheck
