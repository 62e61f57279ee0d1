#pragma once

#include <optional>
#include <vector>

#include "comparisons/settings/run_settings.hpp"
#include "comparisons/studies/split.hpp"

namespace springcheck {

/// The splits of errors, of methods whose continuum is known, against the law of the
/// named reference, or that which the springs follow, or Hencky's; others have none.
/// Throws InputError where nothing can be split as asked.
std::vector<std::optional<SplitPlan>> split_plans(const RunSettings& run,
                                                  const std::vector<Request>& requests);

}  // namespace springcheck
