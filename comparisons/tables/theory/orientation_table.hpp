#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Springs are not isotropic at finite strain: uniaxial stress along directions 100, 110,
/// 111 of mss-cf, from Cauchy-Born and from the springs themselves, and of mss-affine, of
/// sixteen directions and of six; the same in simple shear, turned.
TablePlan plan_orientation_table();

}  // namespace springcheck
