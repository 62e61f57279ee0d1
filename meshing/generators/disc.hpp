#pragma once

#include "meshing/mesh.hpp"

namespace springcheck {

/// A flat cylinder, the sample between a rheometer's plates, in hexahedra.
struct Disc {
  double diameter;  // [m]
  double height;    // [m]
  int across;       // cells along a diameter, at least 3
  int layers;       // cells along the height

  friend bool operator==(const Disc&, const Disc&) = default;
};

/// Mesh of the disc, its axis x = y = 0, with the regions bottom (z = 0), top
/// (z = height) and surface (the rest). A square core of n x n cells has on each side a
/// sector of n x m up to the rim, m = across/4 and n = across - 2 m. The rim is a polygon
/// of 4 n sides x = 2 pi/(4 n) wide, its corners on the circle: its polar moment is
/// smaller than the disc's by x^2/3, 1.3 % with 16 cells across.
///
/// Throws InputError for lengths that are not positive and finite, fewer than 3 cells
/// across or 1 along the height; std::runtime_error with gmsh's own words when it fails.
Mesh generate_disc(const Disc& disc);

}  // namespace springcheck
