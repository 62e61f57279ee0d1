#include "meshing/wavelength.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "meshing/cell_type.hpp"

namespace springcheck {
namespace {

/// One of each pair of opposite directions.
const std::array<Vector3, 13>& directions() {
  static const std::array<Vector3, 13> all = [] {
    std::array<Vector3, 13> found;
    std::size_t count = 0;
    for (int z = 0; z <= 1; ++z)
      for (int y = z == 0 ? 0 : -1; y <= 1; ++y)
        for (int x = z == 0 && y == 0 ? 1 : -1; x <= 1; ++x)
          found[count++] = Vector3(x, y, z).normalized();
    return found;
  }();
  return all;
}

std::size_t nearest_direction(const Vector3& edge) {
  std::size_t nearest = 0;
  for (std::size_t d = 1; d < directions().size(); ++d)
    if (std::abs(directions()[d].dot(edge)) > std::abs(directions()[nearest].dot(edge)))
      nearest = d;
  return nearest;
}

struct Sums {
  double products = 0, squares = 0;
  std::size_t edges = 0;
};

}  // namespace

double shortest_wavelength(std::span<const CellNodes> cells,
                           std::span<const Vector3> nodes,
                           std::span<const Vector3> field) {
  std::set<std::pair<NodeIndex, NodeIndex>> all_edges;
  for (const CellNodes& cell : cells)
    for (const LocalEdge& edge : edges(type_of(cell)))
      all_edges.insert(std::minmax(cell[edge[0]], cell[edge[1]]));
  std::array<Sums, 13> sums{};
  for (const auto& [a, b] : all_edges) {
    Sums& sum = sums[nearest_direction(nodes[b] - nodes[a])];
    sum.products += field[a].dot(field[b]);
    sum.squares += (field[a].squaredNorm() + field[b].squaredNorm()) / 2;
    ++sum.edges;
  }
  const std::size_t most = std::ranges::max(sums, {}, &Sums::edges).edges;
  double least = 1;
  for (const Sums& sum : sums)
    if (2 * sum.edges >= most && sum.squares > 0)
      least = std::min(least, sum.products / sum.squares);
  return 2 * std::numbers::pi / std::acos(std::clamp(least, -1., 1.));
}

}  // namespace springcheck
