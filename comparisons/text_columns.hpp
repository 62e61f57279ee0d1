#pragma once

#include <string>
#include <vector>

namespace springcheck {

/// Rows of equal length as aligned lines: the first column to the left, the others to the
/// right, two blanks between.
std::string in_columns(const std::vector<std::vector<std::string>>& rows);

}  // namespace springcheck
