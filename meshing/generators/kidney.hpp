#pragma once

#include "meshing/generators/block.hpp"
#include "meshing/mesh.hpp"

namespace springcheck {

/// A body of about a kidney's shape: an ellipsoid, hollowed at its side x > 0 by a
/// smaller one (the hilum), and cut flat below and above so that it can be glued to
/// plates.
struct Kidney {
  std::array<double, 3> size{0.06, 0.11, 0.04};  // [m] along x, y, z, of an adult's
  std::array<int, 3> cells;  // the edge length is the mean of size/cells
  CellPattern pattern = CellPattern::free_tetrahedron;

  friend bool operator==(const Kidney&, const Kidney&) = default;
};

/// Mesh of the kidney, with the regions bottom (z = 0), top (z = size[2]) and surface
/// (the rest), centred at x = y = 0. The ellipsoid extends beyond the flat faces, so that
/// the trimmed height is size[2]; the hilum takes a part of its extent along x.
///
/// Throws InputError for patterns other than free_tetrahedron and free_hexahedron, sizes
/// that are not positive and finite, fewer than one cell along an axis, and what Mesh
/// refuses of gmsh's cells; std::runtime_error with gmsh's own words when it fails.
Mesh generate_kidney(const Kidney& kidney);

}  // namespace springcheck
