#pragma once

#include <vector>

#include "comparisons/studies/split.hpp"
#include "comparisons/tables/plans/sheet_plan.hpp"

namespace springcheck {

/// Where mss-cf's error comes from in the five tests: law or discretisation.
SheetPlan plan_split_table();

/// The same in large deformation, at nu = 0, 1/4 and .4 on a cube of 5 x 5 x 5 cells, of
/// mss-cf, of its springs in logarithms, and of springs that follow a law of finite
/// elements, against their own law and the thesis's.
SheetPlan plan_laws_table();

/// Table split of splits that are computed already.
Sheet split_sheet(const std::vector<Split>& splits,
                  const std::vector<CaseResult>& springs);

/// Springs and finite elements on cubes, on a distorted mixture of cells and on gmsh's
/// tetrahedra, about 5 cells across: compression, shearing and torsion at nu 0, .25, .45
/// and .499.
SheetPlan plan_elements_table();

/// Errors of springs and finite elements in shearing at a deformation of 1e-5, on 2, 4, 8
/// and 16 cells across, by type of cells, with fitted orders.
SheetPlan plan_convergence_table();

/// Hexahedra and prisms against the cells they can be cut into (Golec 2018, section 6.1):
/// mss-affine and finite elements in the thesis's five tests at 5 and 20 %.
SheetPlan plan_subdivision_table();

/// Volumetric locking: the plate force in compression near nu = 1/2 by element.
SheetPlan plan_locking_table();

/// Mss-cf's figures of tables 5.1 to 5.4 as printed, as static equilibria, as the end of
/// dynamics in SI units, and as the end of the thesis's own dynamics in its raw units:
/// what the protocol alone changes.
SheetPlan plan_dynamics_table();

/// Time of explicit steps on this machine: the thesis's two timed scenes beside its
/// printed times, and the data of its figures 5.20 to 5.25, real time and user/real ratio
/// against cells and threads; springs beside plain loops. Measured while the table is
/// made, one body at a time; no case is behind it, and no two runs give the same digits.
SheetPlan plan_performance_table();

/// How time and memory grow with the cells of cubes: of explicit steps, and of static
/// solutions with direct and iterative linear solvers, by springs and finite elements,
/// each with exponents fitted over its sizes. Direct solvers' factors grow faster than
/// bodies, and have sizes of their own. Measured on one thread, one body at a time; no
/// case is behind it, and no two runs give the same digits. Sizes that need more memory
/// than is left, that are expected to take more than `most_seconds`, by the growth of the
/// series so far, or whose solution fails are named in the notes.
Sheet growth_sheet(const std::vector<int>& across,
                   const std::vector<int>& across_directly, double most_seconds = 900);

/// That of 10^3, 10^4, 10^5 and 10^6 cells, about, and for direct solvers up to 2 10^4;
/// measured while the table is made.
SheetPlan plan_growth_table();

}  // namespace springcheck
