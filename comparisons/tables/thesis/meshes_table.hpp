#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Table 5.5 of Golec 2018: cells, nodes and springs of its performance study's
/// meshes, printed and counted. Needs no simulation.
TablePlan plan_meshes_table();

}  // namespace springcheck
