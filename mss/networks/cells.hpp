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

/// For each node the cells around it, each with its share of their volume: a cell of n_e
/// nodes leaves V_e/n_e to each of them.
struct Stars {
  struct Part {
    NodeIndex cell;
    double weight;  // of the cell in means over the star; they add up to 1
  };
  std::vector<std::size_t> first;  // of each node, and the end; empty: there are no stars
  std::vector<Part> parts{};
  std::vector<double> volumes;  // V_n = sum V_e/n_e [m^3], of each node

  [[nodiscard]] std::size_t size() const { return volumes.size(); }
  [[nodiscard]] std::span<const Part> operator[](std::size_t node) const {
    return std::span(parts).subspan(first[node], first[node + 1] - first[node]);
  }
};

enum class StarCells { all, tetrahedra };

/// A star of nodes without any such cell is empty. No stars if there is no such cell.
Stars stars(const Cells& cells, std::size_t nodes, StarCells which);

}  // namespace springcheck::mss
