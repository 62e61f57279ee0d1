#pragma once

#include "comparisons/sheet.hpp"

namespace springcheck {

/// Liver, kidney and spleen in simple shear at the three rates of Golec's figures 4.4 to
/// 4.8: stress by the bi-power law and by the Maxwell branches fitted to it. Needs no
/// simulation.
SheetPlan plan_tissue_table();

}  // namespace springcheck
