#include "meshing/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>
#include <unordered_map>

#include "meshing/hexahedron.hpp"
#include "meshing/input_error.hpp"
#include "meshing/sha256.hpp"

namespace springcheck {
namespace {

struct FaceHash {
  std::size_t operator()(const Quadrilateral& face) const {
    std::size_t hash = 0;
    for (const NodeIndex node : face) hash = hash * 0x9E3779B97F4A7C15U + node;
    return hash ^ (hash >> 29U);
  }
};

/// Number of cells at each face, by the face's ascending nodes.
using FaceUses = std::unordered_map<Quadrilateral, int, FaceHash>;

Quadrilateral ascending(Quadrilateral face) {
  std::ranges::sort(face);
  return face;
}

std::string cell_name(std::size_t number, const HexahedronCorners& x) {
  Vector3 centroid = Vector3::Zero();
  for (const Vector3& corner : x) centroid += corner / 8;
  return fmt::format("hexahedron {} near ({:.6g}, {:.6g}, {:.6g}) m", number,
                     centroid.x(), centroid.y(), centroid.z());
}

void check_nodes(const std::string& source, const std::vector<Vector3>& nodes,
                 const std::vector<Hexahedron>& cells) {
  if (cells.empty()) throw InputError(source, "cells", "at least 1 hexahedron", "0");
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!nodes[i].allFinite())
      throw InputError(source, fmt::format("node {}", i), "finite coordinates",
                       "infinity or not-a-number");
  std::vector<char> used(nodes.size(), 0);
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const NodeIndex node : cells[c]) {
      if (node >= nodes.size())
        throw InputError(source, fmt::format("hexahedron {}", c),
                         fmt::format("node numbers below {}", nodes.size()),
                         std::to_string(node));
      used[node] = 1;
    }
  const auto unused = std::ranges::find(used, 0);
  if (unused != used.end())
    throw InputError(source, fmt::format("node {}", unused - used.begin()),
                     "a cell that uses it", "none");
}

void check_cells(const std::string& source, const std::vector<Vector3>& nodes,
                 const std::vector<Hexahedron>& cells) {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const HexahedronCorners x = corners(cells[c], nodes);
    const double jacobian = smallest_corner_jacobian(x);
    if (!(jacobian > 0))
      throw InputError(source, cell_name(c, x), "positive Jacobians at its corners",
                       fmt::format("{:.3g} m^3", jacobian));
  }
}

std::array<Quadrilateral, 6> faces_of(const Hexahedron& cell) {
  std::array<Quadrilateral, 6> faces;
  std::ranges::transform(hexahedron_faces, faces.begin(), [&](const auto& local) {
    Quadrilateral face;
    std::ranges::transform(local, face.begin(),
                           [&](int i) { return cell[static_cast<std::size_t>(i)]; });
    return face;
  });
  return faces;
}

FaceUses check_faces(const std::string& source, const std::vector<Vector3>& nodes,
                     const std::vector<Hexahedron>& cells) {
  FaceUses uses;
  uses.reserve(4 * cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const Quadrilateral& face : faces_of(cells[c]))
      if (++uses[ascending(face)] > 2)
        throw InputError(source, cell_name(c, corners(cells[c], nodes)),
                         "at most two cells at each of its faces", "three");
  return uses;
}

std::vector<NodeIndex> nodes_of(const std::vector<Quadrilateral>& faces) {
  std::vector<NodeIndex> nodes;
  for (const Quadrilateral& face : faces)
    nodes.insert(nodes.end(), face.begin(), face.end());
  std::ranges::sort(nodes);
  const auto repeated = std::ranges::unique(nodes);
  nodes.erase(repeated.begin(), repeated.end());
  return nodes;
}

Region boundary_of(const std::vector<Hexahedron>& cells, const FaceUses& uses) {
  Region boundary;
  for (const Hexahedron& cell : cells)
    for (const Quadrilateral& face : faces_of(cell))
      if (uses.at(ascending(face)) == 1) boundary.faces.push_back(face);
  boundary.nodes = nodes_of(boundary.faces);
  return boundary;
}

Region checked_region(const std::string& source, const std::string& name,
                      std::vector<Quadrilateral> faces, const FaceUses& uses) {
  if (faces.empty())
    throw InputError(source, fmt::format("region '{}'", name), "at least 1 face", "0");
  Region region{.faces = std::move(faces), .nodes = {}};
  for (const Quadrilateral& face : region.faces) {
    const auto found = uses.find(ascending(face));
    if (found == uses.end() || found->second != 1)
      throw InputError(source,
                       fmt::format("region '{}': face {}", name, fmt::join(face, "-")),
                       "a face of exactly one cell",
                       found == uses.end() ? "a face of none" : "a face inside the body");
  }
  region.nodes = nodes_of(region.faces);
  return region;
}

template <class T>
void append_bytes(std::string& bytes, const std::vector<T>& values) {
  const std::uint64_t count = values.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(T));
}

}  // namespace

Mesh::Mesh(std::string source, std::vector<Vector3> nodes,
           std::vector<Hexahedron> hexahedra,
           std::map<std::string, std::vector<Quadrilateral>> regions)
    : source_(std::move(source)),
      nodes_(std::move(nodes)),
      hexahedra_(std::move(hexahedra)) {
  check_nodes(source_, nodes_, hexahedra_);
  check_cells(source_, nodes_, hexahedra_);
  const FaceUses uses = check_faces(source_, nodes_, hexahedra_);
  for (auto& [name, faces] : regions)
    regions_[name] = checked_region(source_, name, std::move(faces), uses);
  boundary_ = boundary_of(hexahedra_, uses);

  cell_volumes_ = springcheck::cell_volumes(hexahedra_, nodes_);
  volume_ = std::accumulate(cell_volumes_.begin(), cell_volumes_.end(), 0.0);

  std::string bytes;
  append_bytes(bytes, nodes_);
  append_bytes(bytes, hexahedra_);
  for (const auto& [name, region] : regions_) {
    bytes += name;
    append_bytes(bytes, region.faces);
  }
  sha256_ = springcheck::sha256(bytes);
}

const Region& Mesh::region(const std::string& name) const {
  const auto found = regions_.find(name);
  if (found == regions_.end()) {
    std::vector<std::string_view> names;
    for (const auto& [known, region] : regions_) names.push_back(known);
    throw InputError(source_, "region", fmt::format("one of {}", fmt::join(names, ", ")),
                     fmt::format("'{}'", name));
  }
  return found->second;
}

}  // namespace springcheck
