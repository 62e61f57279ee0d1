#include "meshing/generators/z_curve.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "meshing/cell_geometry.hpp"

namespace springcheck {
namespace {

constexpr unsigned bits = 21;  // per axis: three times as many fit into the key

struct Box {
  Vector3 low;
  double edge;  // of the cube that holds it
};

Box box_of(const std::vector<Vector3>& points) {
  Vector3 low = points.front(), high = low;
  for (const Vector3& x : points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return {.low = low, .edge = (high - low).maxCoeff()};
}

std::uint64_t key(const Vector3& point, const Box& box) {
  std::uint64_t interleaved = 0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double place = (point[axis] - box.low[axis]) / box.edge * 0x1p21;
    const auto whole = static_cast<std::uint64_t>(std::min(place, 0x1p21 - 1));
    for (unsigned bit = 0; bit < bits; ++bit)
      interleaved |= (whole >> bit & 1U) << (3 * bit + static_cast<unsigned>(axis));
  }
  return interleaved;
}

/// The place in the old order of each point of the new one.
std::vector<std::size_t> order_of(const std::vector<Vector3>& points, const Box& box) {
  std::vector<std::uint64_t> keys;
  for (const Vector3& x : points) keys.push_back(key(x, box));
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return keys[i]; });
  return order;
}

}  // namespace

MeshParts along_z_curve(const MeshParts& parts) {
  if (parts.nodes.empty()) return parts;
  const Box box = box_of(parts.nodes);
  MeshParts sorted;
  std::vector<NodeIndex> number(parts.nodes.size());
  for (const std::size_t n : order_of(parts.nodes, box)) {
    number[n] = static_cast<NodeIndex>(sorted.nodes.size());
    sorted.nodes.push_back(parts.nodes[n]);
  }
  std::vector<Vector3> middles;
  for (const CellNodes& cell : parts.cells)
    middles.emplace_back(corners(cell, parts.nodes).rowwise().mean());
  for (const std::size_t c : order_of(middles, box)) {
    sorted.cells.emplace_back();
    for (const NodeIndex node : parts.cells[c])
      sorted.cells.back().push_back(number[node]);
  }
  return sorted;
}

}  // namespace springcheck
