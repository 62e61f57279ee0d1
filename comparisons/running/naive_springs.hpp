#pragma once

#include <vector>

#include "mss/networks/network.hpp"

namespace springcheck {

/// The baseline of benchmarks: a lattice of springs as one writes it at first. It has
/// plain loops over springs and cells, square roots and divisions, positions and forces
/// node by node, semi-implicit Euler, one thread and no supports; nothing is vectorised
/// or renumbered.
class NaiveSprings {
 public:
  /// Takes springs of constant rest length with the volume correction of hexahedra. The
  /// nodes start moved by `displacements` [m].
  NaiveSprings(const mss::Network& network, const std::vector<Vector3>& displacements);

  void advance(double dt);

 private:
  struct Cell {
    std::array<NodeIndex, 8> nodes;  // gmsh's order
    double volume;
  };
  void update_forces();

  std::vector<mss::Spring> springs_;
  std::vector<Cell> cells_;
  std::vector<double> masses_;
  double volume_modulus_;
  std::vector<std::array<double, 3>> positions_, velocities_, forces_;
};

}  // namespace springcheck
