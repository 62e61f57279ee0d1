#include "meshing/nodal_patches.hpp"

namespace springcheck {

NodalPatches nodal_patches(const Mesh& mesh, NodalPatchCells which) {
  const std::size_t nodes = mesh.nodes().size();
  NodalPatches result{.first = std::vector<std::size_t>(nodes + 1, 0),
                      .volumes = std::vector<double>(nodes, 0)};
  const auto for_each_share = [&](const auto& visit) {
    for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
      const CellNodes& at = mesh.cells()[c];
      if (which == NodalPatchCells::tetrahedra && type_of(at) != CellType::tetrahedron)
        continue;
      const double share = mesh.cell_volumes()[c] / static_cast<double>(at.size());
      for (const NodeIndex node : at) visit(node, static_cast<NodeIndex>(c), share);
    }
  };
  for_each_share([&](NodeIndex node, NodeIndex, double share) {
    ++result.first[node + 1];
    result.volumes[node] += share;
  });
  for (std::size_t n = 0; n < nodes; ++n) result.first[n + 1] += result.first[n];
  result.parts.resize(result.first.back());
  if (result.parts.empty()) return {};
  std::vector<std::size_t> next = result.first;
  for_each_share([&](NodeIndex node, NodeIndex cell, double share) {
    result.parts[next[node]++] = {.cell = cell, .weight = share / result.volumes[node]};
  });
  return result;
}

}  // namespace springcheck
