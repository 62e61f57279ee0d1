#pragma once

#include <span>
#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck {

/// Some nodes of a mesh, to be found by place. Source: Bentley 1975, the k-d tree, here
/// in an array: the middle of each range parts it, along the longest side of its box.
class PointTree {
 public:
  PointTree(std::span<const Vector3> positions, std::vector<NodeIndex> nodes);

  /// The nodes in a box, its sides included, ascending.
  [[nodiscard]] std::vector<NodeIndex> in_box(const Eigen::AlignedBox3d& box) const;

 private:
  void part(std::size_t begin, std::size_t end);
  void collect(std::size_t begin, std::size_t end, const Eigen::AlignedBox3d& box,
               std::vector<NodeIndex>& found) const;

  std::span<const Vector3> positions_;
  std::vector<NodeIndex> nodes_;
  std::vector<Eigen::Index> axes_;  // of the range whose middle is here
};

}  // namespace springcheck
