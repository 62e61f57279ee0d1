#include "meshing/gmsh/cells.hpp"

#include <gmsh.h>

#include <limits>
#include <unordered_map>

#include "meshing/cell_geometry.hpp"

namespace springcheck {
namespace {

enum class GmshTag : std::size_t {};  // as in gmsh's model: 1-based, with gaps

/// gmsh's number for cells of the type.
int gmsh_type(CellType type) {
  switch (type) {
    case CellType::tetrahedron:
      return 4;
    case CellType::hexahedron:
      return 5;
    case CellType::prism:
      return 6;
    default:
      return 7;
  }
}

/// Nodes that no cell uses yet have no number.
struct NumberedNode {
  Vector3 position;
  NodeIndex number = std::numeric_limits<NodeIndex>::max();
};

std::unordered_map<GmshTag, NumberedNode> gmsh_nodes() {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parametric;
  ::gmsh::model::mesh::getNodes(tags, coordinates, parametric);
  std::unordered_map<GmshTag, NumberedNode> nodes;
  for (std::size_t n = 0; n < tags.size(); ++n)
    nodes[GmshTag{tags[n]}].position = Vector3(&coordinates[3 * n]);
  return nodes;
}

/// The same cell seen in a mirror.
CellNodes mirrored(const CellNodes& cell) {
  switch (type_of(cell)) {
    case CellType::tetrahedron:
      return {cell[0], cell[2], cell[1], cell[3]};
    case CellType::pyramid:
      return {cell[0], cell[3], cell[2], cell[1], cell[4]};
    case CellType::prism:
      return {cell[0], cell[2], cell[1], cell[3], cell[5], cell[4]};
    default:
      return {cell[0], cell[3], cell[2], cell[1], cell[4], cell[7], cell[6], cell[5]};
  }
}

}  // namespace

MeshParts gmsh_cells() {
  std::unordered_map<GmshTag, NumberedNode> nodes = gmsh_nodes();
  MeshParts parts;
  const auto number = [&](GmshTag tag) {
    NumberedNode& node = nodes.at(tag);
    if (node.number == std::numeric_limits<NodeIndex>::max()) {
      node.number = static_cast<NodeIndex>(parts.nodes.size());
      parts.nodes.push_back(node.position);
    }
    return node.number;
  };
  for (const CellType type : all_cell_types) {
    std::vector<std::size_t> tags, corner_tags;
    ::gmsh::model::mesh::getElementsByType(gmsh_type(type), tags, corner_tags);
    for (std::size_t c = 0; c < tags.size(); ++c) {
      CellNodes cell;
      for (std::size_t i = 0; i < node_count(type); ++i)
        cell.push_back(number(GmshTag{corner_tags[c * node_count(type) + i]}));
      if (cell_volume(corners(cell, parts.nodes)) < 0) cell = mirrored(cell);
      parts.cells.push_back(cell);
    }
  }
  return parts;
}

}  // namespace springcheck
