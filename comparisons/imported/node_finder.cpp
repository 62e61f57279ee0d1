#include "comparisons/imported/node_finder.hpp"

#include <algorithm>
#include <cmath>

namespace springcheck {

double smallest_edge(const Mesh& mesh) {
  double smallest = INFINITY;
  for (const CellNodes& cell : mesh.cells())
    for (const auto& [a, b] : edges(type_of(cell)))
      smallest =
          std::min(smallest, (mesh.nodes()[cell[b]] - mesh.nodes()[cell[a]]).norm());
  return smallest;
}

NodeFinder::NodeFinder(const Mesh& mesh) : mesh_(mesh), edge_(smallest_edge(mesh)) {
  for (NodeIndex n = 0; n < mesh.nodes().size(); ++n)
    bins_[bin_of(mesh.nodes()[n])].push_back(n);
}

NodeFinder::Bin NodeFinder::bin_of(const Vector3& point) const {
  Bin bin;
  for (Eigen::Index i = 0; i < 3; ++i)
    bin[static_cast<std::size_t>(i)] = std::floor(point[i] / edge_);
  return bin;
}

std::optional<NodeIndex> NodeFinder::at(const Vector3& point, double rounding) const {
  const double reach = tolerance() + rounding;
  std::optional<NodeIndex> found;
  double distance = reach;
  const auto look_into = [&](const Bin& bin) {
    const auto nodes = bins_.find(bin);
    if (nodes == bins_.end()) return;
    for (const NodeIndex n : nodes->second)
      if ((mesh_.nodes()[n] - point).norm() <= distance) {
        distance = (mesh_.nodes()[n] - point).norm();
        found = n;
      }
  };
  // The bins that the reach touches: one, or up to eight at their borders.
  const Vector3 all_ways = Vector3::Constant(std::min(reach, edge_ / 2));
  const Bin low = bin_of(point - all_ways), high = bin_of(point + all_ways);
  const auto sides = [&](std::size_t i) {
    return low[i] == high[i] ? std::vector{low[i]} : std::vector{low[i], high[i]};
  };
  for (const double x : sides(0))
    for (const double y : sides(1))
      for (const double z : sides(2)) look_into({x, y, z});
  return found;
}

NodeIndex NodeFinder::nearest(const Vector3& point) const {
  const auto& nodes = mesh_.nodes();
  const auto nearest = std::ranges::min_element(
      nodes, {}, [&](const Vector3& node) { return (node - point).norm(); });
  return static_cast<NodeIndex>(nearest - nodes.begin());
}

}  // namespace springcheck
