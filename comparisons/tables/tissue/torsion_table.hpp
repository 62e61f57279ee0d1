#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Torque on a disc of liver, kidney and spleen between a rheometer's plates, its rim
/// sheared by 10, 50 and 100 % at 0.133 1/s: by the bi-power law, and by mss-tissue on
/// three meshes.
TablePlan plan_tissue_torsion_table();

}  // namespace springcheck
