#pragma once

#include "comparisons/tables/plans/sheet_plan.hpp"

namespace springcheck {

/// Liver, kidney and spleen in simple shear at the three rates of Golec's figures 4.4 to
/// 4.8: stress by the bi-power law, by the Maxwell branches fitted to it, by mss-tissue
/// (a case for each strain), and by the thesis's spring force, Eq. 4.4, as printed and
/// repaired; with the root mean square of ln and the largest deviation from the law.
SheetPlan plan_tissue_table();

/// Liver, kidney and spleen in simple shear to 10, 30 and 100 % at rates of 0.001 to
/// 50 1/s: stress by the bi-power law, by the Maxwell branches fitted to it, and by
/// mss-tissue.
SheetPlan plan_tissue_rates_table();

/// Liver, kidney and spleen in simple shear to 100 %: held there for 0.1 to 100 s after a
/// ramp at 0.67 1/s, and on the way back to rest after one at 0.133 1/s. Stress by the
/// bi-power law, with |gamma|^p where strains fall, and by mss-tissue.
SheetPlan plan_tissue_relaxation_table();

/// G' and G'' of liver, kidney and spleen from 0.1 to 100 rad/s: by the bi-power law, by
/// the Maxwell branches fitted to it, and by mss-tissue, two cases each, which end after
/// 10 1/4 cycles of a small oscillation, where the load is largest, and after 10.
SheetPlan plan_tissue_oscillation_table();

/// Torque on a disc of liver, kidney and spleen between a rheometer's plates, its rim
/// sheared by 10, 50 and 100 % at 0.133 1/s: by the bi-power law, and by mss-tissue on
/// three meshes.
SheetPlan plan_tissue_torsion_table();

}  // namespace springcheck
