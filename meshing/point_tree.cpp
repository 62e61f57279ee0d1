#include "meshing/point_tree.hpp"

#include <algorithm>

namespace springcheck {

PointTree::PointTree(std::span<const Vector3> positions, std::vector<NodeIndex> nodes)
    : positions_(positions), nodes_(std::move(nodes)), axes_(nodes_.size()) {
  part(0, nodes_.size());
}

void PointTree::part(std::size_t begin, std::size_t end) {
  if (begin == end) return;
  Eigen::AlignedBox3d box;
  for (std::size_t i = begin; i < end; ++i) box.extend(positions_[nodes_[i]]);
  const std::size_t middle = begin + (end - begin) / 2;
  Eigen::Index& axis = axes_[middle];
  box.sizes().maxCoeff(&axis);
  const auto place = [this](std::size_t i) {
    return nodes_.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::ranges::nth_element(place(begin), place(middle), place(end), {},
                           [&](NodeIndex node) { return positions_[node][axis]; });
  part(begin, middle);
  part(middle + 1, end);
}

void PointTree::collect(std::size_t begin, std::size_t end,
                        const Eigen::AlignedBox3d& box,
                        std::vector<NodeIndex>& found) const {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const Vector3& x = positions_[nodes_[middle]];
  const Eigen::Index axis = axes_[middle];
  if (box.contains(x)) found.push_back(nodes_[middle]);
  if (box.min()[axis] <= x[axis]) collect(begin, middle, box, found);
  if (box.max()[axis] >= x[axis]) collect(middle + 1, end, box, found);
}

std::vector<NodeIndex> PointTree::in_box(const Eigen::AlignedBox3d& box) const {
  std::vector<NodeIndex> found;
  collect(0, nodes_.size(), box, found);
  std::ranges::sort(found);
  return found;
}

}  // namespace springcheck
