#pragma once

#include <vector>

#include "comparisons/cases/described.hpp"

namespace springcheck {

/// Groups of a result file (HDF5, layout 2), and what each holds.
const std::vector<Described>& file_layout();

/// Columns of /cases beside the settings and the measures.
const std::vector<Described>& case_columns();

}  // namespace springcheck
