#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "meshing/generators/generate_block.hpp"
#include "tests/mss/blocks.hpp"

// Meshes of every type of cell, and dense matrices of their networks.
namespace springcheck::mss {

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

/// Cubes of n^3 cells of the grid of edge h [m], cut in each pattern of the grid, their
/// inner nodes off by up to 20 % of h, and one left as it is.
inline std::vector<NamedMesh> distorted_cubes(int n, double h) {
  std::vector<NamedMesh> meshes;
  for (const auto& [name, pattern, description] : cell_patterns())
    if (keeps_grid(pattern))
      meshes.push_back({std::string(name), generate_block({.size = {n * h, n * h, n * h},
                                                           .cells = {n, n, n},
                                                           .pattern = pattern,
                                                           .distortion = 0.2})});
  meshes.push_back({"regular hexahedron", cube(n, h)});
  return meshes;
}

}  // namespace springcheck::mss
