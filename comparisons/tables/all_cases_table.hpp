#pragma once

#include "comparisons/formats/table.hpp"
#include "comparisons/store/columns.hpp"

namespace springcheck {

/// All cases of a result file (read_cases) as one table, in the order of scene, method,
/// nu and deformation: settings that tell them apart, status, and the measures of the
/// comparisons. A case without a measure shows its status instead. Rows that would read
/// alike have in a last column the settings that differ between them.
Table all_cases_table(const Columns& cases);

}  // namespace springcheck
