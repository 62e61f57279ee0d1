#include "meshing/generators/generate_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshing/basics/input_error.hpp"
#include "meshing/generators/extent.hpp"
#include "meshing/generators/free_block.hpp"
#include "meshing/generators/grid_block.hpp"

namespace springcheck {
namespace {

void check(const Block& block) {
  check_extent(describe(block), block.size, block.cells);
  double nodes = 1, cells = 1;
  for (const int along_axis : block.cells) {
    nodes *= along_axis + 1.0;
    cells *= along_axis;
  }
  const bool may_have_centres = block.pattern == CellPattern::pyramid ||
                                block.pattern == CellPattern::tetrahedron_12 ||
                                block.pattern == CellPattern::mixed;
  if (may_have_centres) nodes += cells;
  if (nodes > std::numeric_limits<NodeIndex>::max())
    throw InputError(describe(block), "nodes", "at most 2^32 - 1",
                     fmt::format("{:.3g}", nodes));
  if (!(block.distortion >= 0) || !std::isfinite(block.distortion))
    throw InputError(describe(block), "distortion", "a finite fraction of at least 0",
                     fmt::format("{}", block.distortion));
}

/// The faces of each side of the block, each face from its smallest node number on, in
/// ascending order.
std::map<std::string, std::vector<FaceNodes>> sides(const Block& block,
                                                    const MeshParts& parts) {
  struct Side {
    const char* name;
    Eigen::Index axis;
    double place;
  };
  const std::array<Side, 6> all{{{"bottom", 2, 0},
                                 {"top", 2, block.size[2]},
                                 {"x_min", 0, 0},
                                 {"x_max", 0, block.size[0]},
                                 {"y_min", 1, 0},
                                 {"y_max", 1, block.size[1]}}};
  std::map<std::string, std::vector<FaceNodes>> found;
  for (const CellNodes& cell : parts.cells)
    for (const LocalFace& local : faces(type_of(cell))) {
      FaceNodes face = face_nodes(cell, local);
      for (const auto& [name, axis, place] : all) {
        const bool is_there = std::ranges::all_of(
            face, [&](NodeIndex node) { return parts.nodes[node][axis] == place; });
        if (!is_there) continue;
        std::ranges::rotate(face, std::ranges::min_element(face));
        found[name].push_back(face);
      }
    }
  for (auto& [name, faces] : found) std::ranges::sort(faces);
  return found;
}

}  // namespace

Mesh generate_block(const Block& block) {
  check(block);
  MeshParts parts = keeps_grid(block.pattern) ? grid_block(block) : free_block(block);
  std::map<std::string, std::vector<FaceNodes>> regions = sides(block, parts);
  Mesh mesh(describe(block), std::move(parts.nodes), std::move(parts.cells),
            std::move(regions));
  const double expected = block.size[0] * block.size[1] * block.size[2];
  if (std::abs(mesh.volume() - expected) > 1e-9 * expected)
    throw InputError(mesh.source(), "volume", fmt::format("{:.9g} m^3", expected),
                     fmt::format("{:.9g} m^3", mesh.volume()));
  return mesh;
}

}  // namespace springcheck
