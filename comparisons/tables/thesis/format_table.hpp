#pragma once

#include <string>

#include "comparisons/sheets/table_format.hpp"
#include "comparisons/tables/thesis/tables.hpp"

namespace springcheck {

/// The table as text. Every row names its reference, its status and the key of its case
/// in the result file; a row without a value shows its status in the value's place.
std::string format_table(const Table& table, TableFormat format);

}  // namespace springcheck
