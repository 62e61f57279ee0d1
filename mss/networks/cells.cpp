#include "mss/networks/cells.hpp"

namespace springcheck::mss {

void Cells::add(std::span<const NodeIndex> nodes, std::span<const Vector3> gradients,
                double volume, std::span<const CellSpring> springs) {
  nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
  gradients_.insert(gradients_.end(), gradients.begin(), gradients.end());
  first_node_.push_back(nodes_.size());
  springs_.insert(springs_.end(), springs.begin(), springs.end());
  first_spring_.push_back(springs_.size());
  volumes_.push_back(volume);
}

Stars stars(const Cells& cells, std::size_t nodes, StarCells which) {
  Stars result{.first = std::vector<std::size_t>(nodes + 1, 0),
               .volumes = std::vector<double>(nodes, 0)};
  const auto belongs = [&](std::size_t c) {
    return which == StarCells::all || cells.is_tetrahedron(c);
  };
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!belongs(c)) continue;
    const auto at = cells.nodes(c);
    for (const NodeIndex node : at) {
      ++result.first[node + 1];
      result.volumes[node] += cells.volume(c) / static_cast<double>(at.size());
    }
  }
  for (std::size_t n = 0; n < nodes; ++n) result.first[n + 1] += result.first[n];
  result.parts.resize(result.first.back());
  if (result.parts.empty()) return {};
  std::vector<std::size_t> next = result.first;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!belongs(c)) continue;
    const auto at = cells.nodes(c);
    const double share = cells.volume(c) / static_cast<double>(at.size());
    for (const NodeIndex node : at)
      result.parts[next[node]++] = {.cell = static_cast<NodeIndex>(c),
                                    .weight = share / result.volumes[node]};
  }
  return result;
}

}  // namespace springcheck::mss
