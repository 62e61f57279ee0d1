#pragma once

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// Springs and finite elements on cubes, on a distorted mixture of cells and on gmsh's
/// tetrahedra, about 5 cells across: compression, shearing and torsion at nu 0, .25, .45
/// and .499.
TablePlan plan_elements_table();

}  // namespace springcheck
