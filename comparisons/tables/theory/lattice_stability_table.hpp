#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Critical strain of the infinite lattice in compression and tension with free sides,
/// against A and nu, and the plane wave that is lost there: theory beside the failures of
/// blocks, without any simulation.
TablePlan plan_lattice_stability_table();

}  // namespace springcheck
