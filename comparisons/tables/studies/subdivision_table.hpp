#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Hexahedra and prisms against the cells they can be cut into (Golec 2018, section 6.1):
/// mss-affine and finite elements in the thesis's five tests at 5 and 20 %.
TablePlan plan_subdivision_table();

}  // namespace springcheck
