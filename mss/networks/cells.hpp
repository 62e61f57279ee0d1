#pragma once

#include <span>

#include "mss/networks/deformation.hpp"

namespace springcheck::mss {

/// A spring between two of a cell's own nodes.
struct CellSpring {
  LocalEdge ends;
  double stiffness;  // k [N/m]
  Vector3 rest;      // r, from the first end to the second [m]
};

/// All that forces need of the cells, in flat lists. A cell's mean deformation gradient
/// is F = sum x_a (x) G_a over its nodes.
class Cells {
 public:
  /// gradients: G_a = B_a/V [1/m], one per node, B_a = cell_volume_gradient at rest.
  /// volume: V > 0 at rest [m^3].
  void add(std::span<const NodeIndex> nodes, std::span<const Vector3> gradients,
           double volume, std::span<const CellSpring> springs);

  [[nodiscard]] std::size_t size() const { return volumes_.size(); }
  [[nodiscard]] std::span<const NodeIndex> nodes(std::size_t cell) const {
    return std::span(nodes_).subspan(first_node_[cell], count(first_node_, cell));
  }
  [[nodiscard]] std::span<const Vector3> gradients(std::size_t cell) const {
    return std::span(gradients_).subspan(first_node_[cell], count(first_node_, cell));
  }
  [[nodiscard]] std::span<const CellSpring> springs(std::size_t cell) const {
    return std::span(springs_).subspan(first_spring_[cell], count(first_spring_, cell));
  }
  [[nodiscard]] double volume(std::size_t cell) const { return volumes_[cell]; }
  [[nodiscard]] bool is_tetrahedron(std::size_t cell) const {
    return count(first_node_, cell) == 4;
  }

  /// H = F - I of the cell, with the nodes displaced by u. Exactly zero at rest.
  [[nodiscard]] Matrix3 displacement_gradient(std::size_t cell,
                                              std::span<const Vector3> u) const {
    const auto at = nodes(cell);
    const auto G = gradients(cell);
    Matrix3 H = Matrix3::Zero();
    // The gradients' sum is zero: differences spare a body far away its round-off.
    for (std::size_t a = 1; a < at.size(); ++a)
      H += (u[at[a]] - u[at[0]]) * G[a].transpose();
    return H;
  }

 private:
  static std::size_t count(const std::vector<std::size_t>& first, std::size_t cell) {
    return first[cell + 1] - first[cell];
  }

  std::vector<std::size_t> first_node_{0};  // of each cell, and the end
  std::vector<NodeIndex> nodes_;
  std::vector<Vector3> gradients_;
  std::vector<double> volumes_;
  std::vector<std::size_t> first_spring_{0};
  std::vector<CellSpring> springs_;
};

}  // namespace springcheck::mss
