#include "meshing/files/tagged_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "meshing/basics/input_error.hpp"
#include "meshing/cell_geometry.hpp"

namespace springcheck {
namespace {

std::int64_t number(NodeTag tag) {
  return static_cast<std::int64_t>(tag);
}
std::int64_t number(ElementTag tag) {
  return static_cast<std::int64_t>(tag);
}

std::vector<MshNode> sorted_nodes(const std::string& file, const MshFile& msh) {
  std::vector<MshNode> nodes = msh.nodes;
  std::ranges::sort(nodes, {}, &MshNode::tag);
  const auto twice = std::ranges::adjacent_find(nodes, {}, &MshNode::tag);
  if (twice != nodes.end())
    throw InputError(file, fmt::format("node {}", number(twice->tag)), "to be given once",
                     "it twice");
  return nodes;
}

/// All elements must stand on nodes there are, all nodes in some element.
void check_use(const std::string& file, const MshFile& msh,
               const std::vector<MshNode>& nodes) {
  std::vector<char> is_used(nodes.size(), 0);
  for (const MshElement& element : msh.elements)
    for (const NodeTag tag : element.nodes) {
      const auto found = std::ranges::lower_bound(nodes, tag, {}, &MshNode::tag);
      if (found == nodes.end() || found->tag != tag)
        throw InputError(file,
                         fmt::format("{} {}", element.type->name, number(element.tag)),
                         "nodes of the file", fmt::format("a node {}", number(tag)));
      is_used[static_cast<std::size_t>(found - nodes.begin())] = 1;
    }
  const auto orphan = std::ranges::find(is_used, 0);
  if (orphan != is_used.end())
    throw InputError(
        file,
        fmt::format(
            "node {}",
            number(nodes[static_cast<std::size_t>(orphan - is_used.begin())].tag)),
        "an element that uses it", "none");
}

/// The cells that count, tetrahedra first. Version 2.2 lists a cell once for each of its
/// physical groups.
std::vector<MshElement> counting_cells(const std::string& file, const MshFile& msh) {
  std::vector<MshElement> cells;
  std::ranges::copy_if(msh.elements, std::back_inserter(cells),
                       [](const MshElement& e) { return e.type->dimension == 3; });
  const auto is_grouped = [&](const MshElement& element) {
    return !msh.groups[element.groups].empty();
  };
  if (std::ranges::any_of(cells, is_grouped))
    std::erase_if(cells, [&](const MshElement& e) { return !is_grouped(e); });
  if (cells.empty()) {
    const auto faces = std::ranges::count_if(
        msh.elements, [](const MshElement& e) { return e.type->dimension == 2; });
    throw InputError(file, "cells",
                     "at least 1 tetrahedron, pyramid, prism or hexahedron",
                     fmt::format("0 beside {} triangles and quadrilaterals", faces));
  }
  std::map<ShortList<NodeTag, 8>, std::set<std::size_t>> groups_of;
  std::erase_if(cells, [&](const MshElement& cell) {
    std::set<std::size_t>& groups = groups_of[cell.nodes];
    return groups.insert(cell.groups).second && groups.size() > 1;
  });
  std::ranges::stable_sort(cells, {}, [](const MshElement& e) { return e.nodes.size(); });
  return cells;
}

}  // namespace

TaggedCells tagged_cells(const std::string& file, const MshFile& msh,
                         double metres_per_unit) {
  const std::vector<MshNode> nodes = sorted_nodes(file, msh);
  check_use(file, msh, nodes);
  const std::vector<MshElement> elements = counting_cells(file, msh);
  TaggedCells cells{.file = file};
  for (const MshElement& element : elements)
    cells.node_tags.insert(cells.node_tags.end(), element.nodes.begin(),
                           element.nodes.end());
  std::ranges::sort(cells.node_tags);
  const auto repeated = std::ranges::unique(cells.node_tags);
  cells.node_tags.erase(repeated.begin(), repeated.end());
  for (const NodeTag tag : cells.node_tags) {
    const auto found = std::ranges::lower_bound(nodes, tag, {}, &MshNode::tag);
    cells.nodes.emplace_back(metres_per_unit * found->position);
    if (!cells.nodes.back().allFinite())
      throw InputError(file, fmt::format("node {}", number(tag)), "finite coordinates",
                       fmt::format("({}, {}, {})", found->position.x(),
                                   found->position.y(), found->position.z()));
  }
  for (const MshElement& element : elements) {
    cells.cell_tags.push_back(element.tag);
    cells.cells.emplace_back();
    for (const NodeTag tag : element.nodes)
      cells.cells.back().push_back(*find_node(cells, tag));
  }
  return cells;
}

std::optional<NodeIndex> find_node(const TaggedCells& cells, NodeTag tag) {
  const auto found = std::ranges::lower_bound(cells.node_tags, tag);
  if (found == cells.node_tags.end() || *found != tag) return std::nullopt;
  return static_cast<NodeIndex>(found - cells.node_tags.begin());
}

std::string name_of_node(const TaggedCells& cells, NodeIndex node) {
  return fmt::format("node {}", number(cells.node_tags[node]));
}

std::string name_of_cell(const TaggedCells& cells, std::size_t cell) {
  const Vector3 middle = corners(cells.cells[cell], cells.nodes).rowwise().mean();
  return fmt::format("{} {} near ({:.6g}, {:.6g}, {:.6g}) m",
                     name_of(type_of(cells.cells[cell])), number(cells.cell_tags[cell]),
                     middle.x(), middle.y(), middle.z());
}

}  // namespace springcheck
