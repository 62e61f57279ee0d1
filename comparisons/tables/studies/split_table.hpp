#pragma once

#include <vector>

#include "comparisons/studies/split.hpp"
#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// The plan of a table of where mss-cf's error comes from in the five tests: law or
/// discretisation.
TablePlan plan_split_table();

/// The plan of the same table in large deformation, at nu = 0, 1/4 and .4 on a cube of
/// 5 x 5 x 5 cells, for mss-cf, for its springs in logarithms, and for springs that
/// follow a law of finite elements, against their own law and the thesis's.
TablePlan plan_laws_table();

/// The table "split" of splits that are computed already.
Table split_table(const std::vector<Split>& splits,
                  const std::vector<CaseResult>& springs);

}  // namespace springcheck
