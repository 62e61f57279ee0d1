#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Liver, kidney and spleen in simple shear at the three rates of Golec's figures 4.4 to
/// 4.8: stress by the bi-power law, by the Maxwell branches fitted to it, by mss-tissue
/// (a case for each strain), and by the thesis's spring force, Eq. 4.4, as printed and
/// repaired; with the root mean square of ln and the largest deviation from the law.
TablePlan plan_tissue_table();

}  // namespace springcheck
