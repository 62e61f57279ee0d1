#pragma once

namespace springcheck {

// Each meshes gmsh's current model, geometry synchronised, with edges of about a length
// in the model's unit.

/// Delaunay tetrahedra, unless the geometry asks for layers of prisms.
void generate_tetrahedra(double edge_length);

/// Tetrahedra of twice the edge, each cut straight into four hexahedra, so that a curved
/// surface is met by the tetrahedra's corners alone.
void generate_hexahedra(double edge_length);

}  // namespace springcheck
