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

/// Asks gmsh for edges of this length everywhere [m].
void set_edge_length(double length);

/// Meshes gmsh's current model by Delaunay tetrahedra, what else it asks for aside.
void generate_mesh();

}  // namespace springcheck
