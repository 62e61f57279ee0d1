#pragma once

#include "comparisons/tables/plans/sheet_plan.hpp"

namespace springcheck {

/// The mss-cf lattice is not isotropic at finite strain: uniaxial stress along its
/// directions 100, 110, 111, from Cauchy-Born and from the springs themselves.
SheetPlan plan_orientation_table();

}  // namespace springcheck
