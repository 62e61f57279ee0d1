#pragma once

#include "comparisons/tables/plans/sheet_plan.hpp"

namespace springcheck {

/// Critical strain of the infinite lattice in compression and tension with free sides,
/// against A and nu, and the plane wave that is lost there: theory beside the failures of
/// blocks, without any simulation.
SheetPlan plan_lattice_stability_table();

}  // namespace springcheck
