#include "meshing/generators/extent.hpp"

#include <fmt/format.h>

#include <cmath>

#include "meshing/basics/input_error.hpp"

namespace springcheck {

void check_extent(const std::string& source, const std::array<double, 3>& size,
                  const std::array<int, 3>& cells) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(size[axis] > 0) || !std::isfinite(size[axis]))
      throw InputError(source, "size", "positive finite lengths",
                       fmt::format("{}", size[axis]));
    if (cells[axis] < 1)
      throw InputError(source, "cells", "at least 1 along each axis",
                       std::to_string(cells[axis]));
  }
}

}  // namespace springcheck
