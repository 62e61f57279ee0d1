#include "meshing/gmsh/algorithms.hpp"

#include <gmsh.h>

namespace springcheck {

void generate_tetrahedra(double edge_length) {
  ::gmsh::option::setNumber("Mesh.MeshSizeMin", edge_length);
  ::gmsh::option::setNumber("Mesh.MeshSizeMax", edge_length);
  ::gmsh::option::setNumber("Mesh.Algorithm3D", 1);  // Delaunay; some others crash
  ::gmsh::model::mesh::generate(3);
}

void generate_hexahedra(double edge_length) {
  ::gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 2);  // all hexahedra
  // Middles of edges stay there: pulled onto a curved surface they turn cells over.
  ::gmsh::option::setNumber("Mesh.SecondOrderLinear", 1);
  generate_tetrahedra(2 * edge_length);
}

}  // namespace springcheck
