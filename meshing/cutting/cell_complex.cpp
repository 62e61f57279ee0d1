#include "meshing/cutting/cell_complex.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <utility>

namespace springcheck {

CellComplex::CellComplex(const Mesh& mesh)
    : cells_(mesh.cells()),
      at_nodes_(mesh.nodes().size()),
      old_nodes_(mesh.nodes().size()) {
  for (std::size_t t = 0; t < all_cell_types.size(); ++t) {
    const auto count = static_cast<std::uint32_t>(mesh.count(all_cell_types[t]));
    first_cells_[t + 1] = first_cells_[t] + count;
    first_faces_[t + 1] = first_faces_[t] + count * faces(all_cell_types[t]).size();
  }
  for (const CellNodes& cell : cells_)
    for (const NodeIndex node : cell) ++at_nodes_[node].count;
  std::uint32_t first = 0;
  for (AtNode& at : at_nodes_) {
    at.first = first;
    first += std::exchange(at.count, 0);
  }
  cells_at_nodes_.resize(first);
  for (std::uint32_t c = 0; c < cells_.size(); ++c)
    for (const NodeIndex node : cells_[c]) {
      AtNode& at = at_nodes_[node];
      cells_at_nodes_[at.first + at.count++] = c;
    }
  across_.assign(first_faces_.back(), none);
  for (std::uint32_t c = 0; c < cells_.size(); ++c)
    for (std::uint8_t f = 0; f < face_count(c); ++f) {
      if (across({c, f}) != none) continue;  // found from the other side
      const FaceNodes nodes = ascending(nodes_of(CellSide{c, f}));
      for (const std::uint32_t d : cells_at(nodes[0])) {
        if (d <= c) continue;
        const auto other = face_with(d, nodes);
        if (!other) continue;
        across_[first_face(c) + f] = d;
        across_[first_face(d) + other->face] = c;
      }
    }
}

std::optional<CellSide> CellComplex::face_with(std::uint32_t cell,
                                               const FaceNodes& nodes) const {
  const CellNodes& all = cells_[cell];
  for (const NodeIndex node : nodes)  // most cells end here
    if (std::ranges::find(all, node) == all.end()) return std::nullopt;
  for (std::uint8_t f = 0; f < face_count(cell); ++f)
    if (ascending(nodes_of(CellSide{cell, f})) == nodes) return CellSide{cell, f};
  return std::nullopt;
}

CellSide CellComplex::face_with(const FaceNodes& nodes) const {
  const FaceNodes sorted = ascending(nodes);
  for (const std::uint32_t cell : cells_at(nodes[0]))
    if (const auto face = face_with(cell, sorted)) return *face;
  throw std::logic_error("CellComplex::face_with: a face of no cell");
}

CellSide CellComplex::other_side(const CellSide& face) const {
  assert(across(face) != none);
  return *face_with(across(face), ascending(nodes_of(face)));
}

std::size_t CellComplex::first_face(std::uint32_t cell) const {
  std::size_t t = 0;  // the cell's type, which one that was removed does not tell itself
  while (cell >= first_cells_[t + 1]) ++t;
  return first_faces_[t] + (cell - first_cells_[t]) * faces(all_cell_types[t]).size();
}

void CellComplex::part(std::span<const CellSide> parted) {
  std::vector<NodeIndex> changed;
  for (const CellSide& face : parted) {
    const FaceNodes nodes = nodes_of(face);
    changed.insert(changed.end(), nodes.begin(), nodes.end());
    close(face);
  }
  separate(std::move(changed));
}

void CellComplex::remove(std::span<const std::uint32_t> removed) {
  std::vector<NodeIndex> changed;
  for (const std::uint32_t cell : removed) {
    for (std::uint8_t f = 0; f < face_count(cell); ++f)
      if (across({cell, f}) != none) close({cell, f});
    for (const NodeIndex node : cells_[cell]) {
      changed.push_back(node);
      AtNode& at = at_nodes_[node];
      const auto first = cells_at_nodes_.begin() + at.first;
      std::remove(first, first + at.count, cell);
      --at.count;
    }
    cells_[cell] = {};
  }
  separate(std::move(changed));
}

void CellComplex::close(const CellSide& face) {
  const CellSide other = other_side(face);
  across_[first_face(face.cell) + face.face] = none;
  across_[first_face(other.cell) + other.face] = none;
}

void CellComplex::separate(std::vector<NodeIndex> nodes) {
  std::ranges::sort(nodes);
  const auto repeated = std::ranges::unique(nodes);
  nodes.erase(repeated.begin(), repeated.end());
  for (const NodeIndex node : nodes) separate(node);
}

void CellComplex::separate(NodeIndex node) {
  const AtNode all = at_nodes_[node];
  std::vector<std::uint32_t> left(cells_at(node).begin(), cells_at(node).end());
  std::uint32_t first = all.first;
  while (!left.empty()) {
    // A part begins with the lowest cell that is left.
    std::vector<std::uint32_t> part{left.front()};
    left.erase(left.begin());
    for (std::size_t i = 0; i < part.size(); ++i)
      for (std::uint8_t f = 0; f < face_count(part[i]); ++f) {
        if (std::ranges::count(nodes_of(CellSide{part[i], f}), node) == 0) continue;
        const auto joined = std::ranges::find(left, across({part[i], f}));
        if (joined == left.end()) continue;
        part.push_back(*joined);
        left.erase(joined);
      }
    std::ranges::sort(part);
    const AtNode at{first, static_cast<std::uint32_t>(part.size())};
    std::ranges::copy(part, cells_at_nodes_.begin() + first);
    if (first == all.first) {
      at_nodes_[node] = at;
    } else {
      const auto copy = static_cast<NodeIndex>(at_nodes_.size());
      at_nodes_.push_back(at);
      origins_.push_back(origin(node));
      for (const std::uint32_t cell : part)
        std::ranges::replace(cells_[cell], node, copy);
    }
    first += at.count;
  }
}

}  // namespace springcheck
