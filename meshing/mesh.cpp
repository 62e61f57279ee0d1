#include "meshing/mesh.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ranges>
#include <string_view>
#include <unordered_map>

#include "meshing/basics/input_error.hpp"
#include "meshing/basics/sha256.hpp"
#include "meshing/basics/text.hpp"
#include "meshing/cell_geometry.hpp"

namespace springcheck {
namespace {

struct FaceHash {
  std::size_t operator()(const FaceNodes& face) const {
    std::size_t hash = 0;
    for (const NodeIndex node : face) hash = hash * 0x9E3779B97F4A7C15U + node;
    return hash ^ (hash >> 29U);
  }
};

struct FaceUse {
  FaceNodes first;  // as the first of its cells lists it
  int cells;
};

/// The uses of faces, by the faces' ascending nodes.
using FaceUses = std::unordered_map<FaceNodes, FaceUse, FaceHash>;

std::string cell_name(std::size_t index, const CellNodes& cell,
                      const std::vector<Vector3>& nodes) {
  Vector3 centre = Vector3::Zero();
  for (const NodeIndex node : cell)
    centre += nodes[node] / static_cast<double>(cell.size());
  return fmt::format("{} {} near ({:.6g}, {:.6g}, {:.6g}) m", name_of(type_of(cell)),
                     index + 1, centre.x(), centre.y(), centre.z());
}

void check_nodes(const std::string& source, const std::vector<Vector3>& nodes,
                 const std::vector<CellNodes>& cells) {
  if (cells.empty()) throw InputError(source, "cells", "at least 1", "0");
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!nodes[i].allFinite())
      throw InputError(source, fmt::format("node {}", i + 1), "finite coordinates",
                       "infinity or not-a-number");
  std::vector<char> used(nodes.size(), 0);
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const NodeIndex node : cells[c]) {
      if (node >= nodes.size())
        throw InputError(source, fmt::format("{} {}", name_of(type_of(cells[c])), c + 1),
                         fmt::format("node numbers up to {}", nodes.size()),
                         std::to_string(node + 1));
      used[node] = 1;
    }
  const auto unused = std::ranges::find(used, 0);
  if (unused != used.end())
    throw InputError(source, fmt::format("node {}", 1 + (unused - used.begin())),
                     "a cell that uses it", "none");
}

void check_cells(const std::string& source, const std::vector<Vector3>& nodes,
                 const std::vector<CellNodes>& cells) {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const double jacobian = smallest_corner_jacobian(corners(cells[c], nodes));
    if (!(jacobian > 0))
      throw InputError(source, cell_name(c, cells[c], nodes),
                       "positive Jacobians at its corners",
                       fmt::format("{:.3g} m^3", jacobian));
  }
}

/// Calls visit(face) for each face of the cell.
template <class Visit>
void for_each_face(const CellNodes& cell, Visit&& visit) {
  for (const LocalFace& face : faces(type_of(cell))) visit(face_nodes(cell, face));
}

/// Whether two cells see their common face from its two sides: they list its nodes in
/// opposite order.
bool are_opposite(const FaceNodes& a, const FaceNodes& b) {
  const std::size_t count = a.size();
  const auto first = static_cast<std::size_t>(std::ranges::find(b, a[0]) - b.begin());
  for (std::size_t i = 1; i < count; ++i)
    if (b[(first + count - i) % count] != a[i]) return false;
  return true;
}

FaceUses check_faces(const std::string& source, const std::vector<Vector3>& nodes,
                     const std::vector<CellNodes>& cells) {
  FaceUses uses;
  uses.reserve(4 * cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
    for_each_face(cells[c], [&](const FaceNodes& face) {
      const auto [use, is_new] = uses.try_emplace(ascending(face), FaceUse{face, 1});
      if (is_new) return;
      const auto refuse = [&](const char* expected, const char* got) {
        throw InputError(source, cell_name(c, cells[c], nodes), expected, got);
      };
      if (++use->second.cells > 2)
        refuse("at most two cells at each of its faces", "three");
      if (!are_opposite(use->second.first, face))
        refuse("its neighbour on the other side of each of its faces",
               "one on the same side: the cells overlap, or there are two of one");
    });
  return uses;
}

std::vector<NodeIndex> nodes_of(const std::vector<FaceNodes>& faces) {
  std::vector<NodeIndex> nodes;
  for (const FaceNodes& face : faces) nodes.insert(nodes.end(), face.begin(), face.end());
  std::ranges::sort(nodes);
  const auto repeated = std::ranges::unique(nodes);
  nodes.erase(repeated.begin(), repeated.end());
  return nodes;
}

Region boundary_of(const std::vector<CellNodes>& cells, const FaceUses& uses) {
  Region boundary;
  for (const CellNodes& cell : cells)
    for_each_face(cell, [&](const FaceNodes& face) {
      if (uses.at(ascending(face)).cells == 1) boundary.faces.push_back(face);
    });
  boundary.nodes = nodes_of(boundary.faces);
  return boundary;
}

/// Names are links in result files, words in JSON and on command lines, lines in
/// messages.
void check_region_name(const std::string& source, const std::string& name) {
  constexpr std::size_t longest = 1000;
  const bool has_control = std::ranges::any_of(
      name, [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; });
  if (name.empty() || name.size() > longest || has_control || !is_utf8(name))
    throw InputError(source, fmt::format("region {}", quotation(name)),
                     fmt::format("a name of 1 to {} bytes of UTF-8, none of them a "
                                 "control character",
                                 longest),
                     name.empty()            ? "an empty one"
                     : name.size() > longest ? fmt::format("{} bytes", name.size())
                     : has_control           ? "one with a control character"
                                             : "bytes that are no UTF-8");
}

/// "3, 7, 8"
std::string numbers_of(const FaceNodes& face) {
  const auto number = [](NodeIndex node) { return node + 1; };
  return fmt::format("{}", fmt::join(face | std::views::transform(number), ", "));
}

Region checked_region(const std::string& source, const std::string& name,
                      std::vector<FaceNodes> faces, const FaceUses& uses) {
  check_region_name(source, name);
  if (faces.empty())
    throw InputError(source, fmt::format("region '{}'", name), "at least 1 face", "0");
  Region region{.faces = std::move(faces)};
  for (const FaceNodes& face : region.faces) {
    const auto found = uses.find(ascending(face));
    if (found == uses.end() || found->second.cells != 1)
      throw InputError(
          source, fmt::format("region '{}': face of nodes {}", name, numbers_of(face)),
          "a face of exactly one cell",
          found == uses.end() ? "a face of none" : "a face inside the body");
  }
  region.nodes = nodes_of(region.faces);
  return region;
}

void append_bytes(std::string& bytes, const void* data, std::size_t count) {
  bytes.append(static_cast<const char*>(data), count);
}

void append_count(std::string& bytes, std::uint64_t count) {
  append_bytes(bytes, &count, sizeof count);
}

/// Cells or faces, each with its number of nodes.
template <class List>
void append_lists(std::string& bytes, const std::vector<List>& lists) {
  append_count(bytes, lists.size());
  for (const List& list : lists) {
    append_count(bytes, list.size());
    append_bytes(bytes, list.begin(), list.size() * sizeof(NodeIndex));
  }
}

}  // namespace

Mesh::Mesh(std::string source, std::vector<Vector3> nodes, std::vector<CellNodes> cells,
           std::map<std::string, std::vector<FaceNodes>> regions,
           std::set<std::string> surfaces_elsewhere)
    : source_(std::move(source)),
      nodes_(std::move(nodes)),
      cells_(std::move(cells)),
      surfaces_elsewhere_(std::move(surfaces_elsewhere)) {
  std::ranges::stable_sort(cells_, {}, &CellNodes::size);
  check_nodes(source_, nodes_, cells_);
  check_cells(source_, nodes_, cells_);
  const FaceUses uses = check_faces(source_, nodes_, cells_);
  for (auto& [name, faces] : regions)
    regions_[name] = checked_region(source_, name, std::move(faces), uses);
  boundary_ = boundary_of(cells_, uses);

  cell_volumes_ = springcheck::cell_volumes(cells_, nodes_);
  volume_ = std::accumulate(cell_volumes_.begin(), cell_volumes_.end(), 0.0);

  std::string bytes;
  append_count(bytes, nodes_.size());
  append_bytes(bytes, nodes_.data(), nodes_.size() * sizeof(Vector3));
  append_lists(bytes, cells_);
  for (const auto& [name, region] : regions_) {
    bytes += name;
    append_lists(bytes, region.faces);
  }
  sha256_ = springcheck::sha256(bytes);
}

double Mesh::mean_cell_edge() const {
  return std::cbrt(volume_ / static_cast<double>(cells_.size()));
}

std::size_t Mesh::count(CellType type) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      cells_, [&](const CellNodes& cell) { return type_of(cell) == type; }));
}

const Region& Mesh::region(const std::string& name) const {
  const auto found = regions_.find(name);
  if (surfaces_elsewhere_.contains(name))
    throw InputError(source_, "region", "a surface on the boundary",
                     fmt::format("'{}', which is not on it throughout", name));
  if (found == regions_.end()) {
    std::vector<std::string_view> names;
    for (const auto& [known, region] : regions_) names.push_back(known);
    throw InputError(source_, "region",
                     names.empty() ? "a surface with a name"
                                   : fmt::format("one of {}", fmt::join(names, ", ")),
                     fmt::format("'{}'", name));
  }
  return found->second;
}

}  // namespace springcheck
