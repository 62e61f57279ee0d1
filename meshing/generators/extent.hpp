#pragma once

#include <array>
#include <string>

namespace springcheck {

/// Throws InputError, naming the source, unless the lengths [m] are positive and finite
/// and there is at least one cell along each axis.
void check_extent(const std::string& source, const std::array<double, 3>& size,
                  const std::array<int, 3>& cells);

}  // namespace springcheck
