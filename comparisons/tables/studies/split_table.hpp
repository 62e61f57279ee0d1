#pragma once

#include "comparisons/studies/split.hpp"
#include "comparisons/tables/plans/sheet_plan.hpp"

namespace springcheck {

/// Where mss-cf's error comes from in the five tests: law or discretisation.
SheetPlan plan_split_table();

/// The sheet of splits that are computed already.
Sheet split_sheet(const std::vector<Split>& splits,
                  const std::vector<CaseResult>& springs);

}  // namespace springcheck
