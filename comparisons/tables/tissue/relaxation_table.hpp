#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Liver, kidney and spleen in simple shear to 100 %: held there for 0.1 to 100 s after a
/// ramp at 0.67 1/s, and on the way back to rest after one at 0.133 1/s. Stress by the
/// bi-power law, with |gamma|^p where strains fall, and by mss-tissue.
TablePlan plan_tissue_relaxation_table();

}  // namespace springcheck
