#include "meshing/gmsh/box.hpp"

#include <gmsh.h>

namespace springcheck {

GmshBottom add_bottom(double width, double depth, double z) {
  namespace geo = ::gmsh::model::geo;
  const std::array points{geo::addPoint(0, 0, z), geo::addPoint(width, 0, z),
                          geo::addPoint(width, depth, z), geo::addPoint(0, depth, z)};
  std::array<int, 4> edges{};
  for (std::size_t i = 0; i < 4; ++i)
    edges[i] = geo::addLine(points[i], points[(i + 1) % 4]);
  const int loop = geo::addCurveLoop({edges.begin(), edges.end()});
  return {.surface = geo::addPlaneSurface({loop}), .edges = edges};
}

}  // namespace springcheck
