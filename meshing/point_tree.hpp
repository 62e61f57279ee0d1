#pragma once

#include <memory>
#include <span>
#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck {

/// Some nodes of a mesh, to be found by place: an R-tree of Boost.Geometry.
class PointTree {
 public:
  PointTree(std::span<const Vector3> positions, std::span<const NodeIndex> nodes);
  ~PointTree();

  /// The nodes in a box, its sides included, ascending.
  [[nodiscard]] std::vector<NodeIndex> in_box(const Eigen::AlignedBox3d& box) const;

  /// The node nearest to the point, any of those that are equally near. There must be
  /// one.
  [[nodiscard]] NodeIndex nearest(const Vector3& point) const;

 private:
  struct Tree;  // Boost.Geometry takes ten seconds to compile, in one file only
  std::unique_ptr<const Tree> tree_;
};

}  // namespace springcheck
