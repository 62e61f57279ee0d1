#include "meshing/generators/disc.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "meshing/basics/input_error.hpp"
#include "meshing/generators/between_plates.hpp"
#include "meshing/generators/extent.hpp"
#include "meshing/gmsh/cells.hpp"
#include "meshing/gmsh/session.hpp"

namespace springcheck {
namespace {

std::string describe(const Disc& disc) {
  return fmt::format("disc {} x {} m in {} cells across, {} layers", disc.diameter,
                     disc.height, disc.across, disc.layers);
}

void check(const Disc& disc) {
  check_extent(describe(disc), {disc.diameter, disc.diameter, disc.height},
               {disc.across, disc.across, disc.layers});
  if (disc.across < 3)
    throw InputError(describe(disc), "cells", "at least 3 across a disc",
                     std::to_string(disc.across));
}

/// Adds the disc's bottom, of the diameter 1 and to be cut into rectangles, to gmsh's
/// current model. Returns its surfaces.
::gmsh::vectorpair add_disc(const Disc& disc) {
  namespace geo = ::gmsh::model::geo;
  const int of_sector = std::max(1, disc.across / 4),
            of_core = disc.across - 2 * of_sector;
  // Cells are alike along x where `across` is a multiple of 4; beyond .35 those of the
  // sectors would be too flat at their spokes.
  const double core_corner =
      std::min(0.35, std::numbers::sqrt2 / 2 * of_core / disc.across);
  const int centre = geo::addPoint(0, 0, 0);
  std::array<int, 4> inner{}, outer{}, sides{}, arcs{}, spokes{};
  for (std::size_t i = 0; i < 4; ++i) {
    const double angle = (0.25 + 0.5 * static_cast<double>(i)) * std::numbers::pi;
    const double x = std::cos(angle), y = std::sin(angle);
    inner[i] = geo::addPoint(core_corner * x, core_corner * y, 0);
    outer[i] = geo::addPoint(0.5 * x, 0.5 * y, 0);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    sides[i] = geo::addLine(inner[i], inner[next]);
    arcs[i] = geo::addCircleArc(outer[i], centre, outer[next]);
    spokes[i] = geo::addLine(inner[i], outer[i]);
    for (const int curve : {sides[i], arcs[i]})
      geo::mesh::setTransfiniteCurve(curve, of_core + 1);
    geo::mesh::setTransfiniteCurve(spokes[i], of_sector + 1);
  }
  std::vector<std::vector<int>> outlines{{sides.begin(), sides.end()}};
  for (std::size_t i = 0; i < 4; ++i)
    outlines.push_back({spokes[i], arcs[i], -spokes[(i + 1) % 4], -sides[i]});
  ::gmsh::vectorpair surfaces;
  for (const std::vector<int>& outline : outlines) {
    const int surface = geo::addPlaneSurface({geo::addCurveLoop(outline)});
    geo::mesh::setTransfiniteSurface(surface);
    geo::mesh::setRecombine(2, surface);
    surfaces.emplace_back(2, surface);
  }
  return surfaces;
}

MeshParts disc_cells(const Disc& disc) {
  namespace geo = ::gmsh::model::geo;
  const GmshSession session("disc");
  ::gmsh::vectorpair above;
  geo::extrude(add_disc(disc), 0, 0, disc.height / disc.diameter, above, {disc.layers},
               {}, true);
  geo::synchronize();
  ::gmsh::model::mesh::generate(3);
  return gmsh_cells();
}

}  // namespace

Mesh generate_disc(const Disc& disc) try {
  check(disc);
  return mesh_between_plates(describe(disc), disc_cells(disc), disc.diameter,
                             disc.height);
} catch (const std::string& message) {  // what gmsh throws
  throw std::runtime_error("gmsh: " + message);
}

}  // namespace springcheck
