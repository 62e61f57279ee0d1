#pragma once

#include <string>
#include <vector>

#include "comparisons/running/case_result.hpp"

namespace springcheck {

/// The results as an aligned table, reasons and reference below it.
std::string results_text(const std::vector<CaseResult>& results);

}  // namespace springcheck
