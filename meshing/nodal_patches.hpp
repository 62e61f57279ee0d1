#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck {

/// The cells around each node, each with its share of their volume: a cell of n_e nodes
/// leaves V_e/n_e to each of them. Means over nodal patches are what keeps linear cells
/// of any type from locking as nu goes to 1/2: Bonet and Burton 1998, A simple average
/// nodal pressure tetrahedral element, Communications in Numerical Methods in Engineering
/// 14, 437-449.
struct NodalPatches {
  struct Part {
    NodeIndex cell;
    double weight;  // of the cell in means over the nodal patch; they add up to 1
  };
  std::vector<std::size_t>
      first;  // of each node, and the end; empty: there are no nodal patches
  std::vector<Part> parts{};
  std::vector<double> volumes;  // V_n = sum V_e/n_e [m^3], of each node

  [[nodiscard]] std::size_t size() const { return volumes.size(); }
  [[nodiscard]] std::span<const Part> operator[](std::size_t node) const {
    return std::span(parts).subspan(first[node], first[node + 1] - first[node]);
  }
};

/// The nodes of a nodal patch's cells, ascending. nodes_of(cell) gives those of one cell.
template <class NodesOf>
std::vector<NodeIndex> nodes_of_patch(std::span<const NodalPatches::Part> nodal_patch,
                                      const NodesOf& nodes_of) {
  std::vector<NodeIndex> nodes;
  for (const auto& [cell, weight] : nodal_patch) {
    const auto& at = nodes_of(cell);
    nodes.insert(nodes.end(), at.begin(), at.end());
  }
  std::ranges::sort(nodes);
  const auto repeated = std::ranges::unique(nodes);
  nodes.erase(repeated.begin(), repeated.end());
  return nodes;
}

enum class NodalPatchCells { all, tetrahedra };

/// The nodal patches of such cells. That of a node without any such cell is empty; there
/// are no nodal patches if the mesh has no such cell.
NodalPatches nodal_patches(const Mesh& mesh, NodalPatchCells which);

}  // namespace springcheck
