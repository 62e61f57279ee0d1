#pragma once

#include <array>

namespace springcheck {

/// Bottom of a box in gmsh's current model, to be extruded, with its edges along x, y,
/// x, y in turn.
struct GmshBottom {
  int surface;
  std::array<int, 4> edges;
};
GmshBottom add_bottom(double width, double depth, double z);

}  // namespace springcheck
