#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Mss-cf's figures of tables 5.1 to 5.4 as printed, as static equilibria, as the end of
/// dynamics in SI units, and as the end of the thesis's own dynamics in its raw units:
/// what the protocol alone changes.
TablePlan plan_dynamics_table();

}  // namespace springcheck
