#pragma once

#include "comparisons/tables/plans/sheet_plan.hpp"

namespace springcheck {

/// Springs are not isotropic at finite strain: uniaxial stress along directions 100, 110,
/// 111 of mss-cf, from Cauchy-Born and from the springs themselves, and of mss-affine, of
/// sixteen directions and of six; the same in simple shear, turned.
SheetPlan plan_orientation_table();

/// Lowest natural frequencies of the free cube and of the cantilever: springs against
/// finite elements and theory, with no simulation of a scene behind them.
SheetPlan plan_modes_table();

/// Critical strain of the infinite lattice in compression and tension with free sides,
/// against A and nu, and the plane wave that is lost there: theory beside the failures of
/// blocks, without any simulation.
SheetPlan plan_lattice_stability_table();

/// Golec's four springs: the force of his figure 3.2 against extension, and the loop
/// under a load that grows and goes back.
SheetPlan plan_four_springs_table();

/// Borders of the integrators' stability regions, of Golec 2018, figures 2.2 and 2.3, and
/// in the plane of omega dt and zeta: found by stepping, beside those on paper.
SheetPlan plan_regions_table();

}  // namespace springcheck
