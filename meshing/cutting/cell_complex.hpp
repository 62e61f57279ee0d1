#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck {

/// A face as one of its cells has it.
struct CellSide {
  std::uint32_t cell;
  std::uint8_t face;  // in faces(type of the cell)

  friend auto operator<=>(const CellSide&, const CellSide&) = default;
};

/// Which cells of a body are joined: by faces, and at nodes through faces that hold the
/// node. Faces are parted and cells removed in time in proportion to what changes,
/// whatever the body's size. Cells and nodes keep their numbers, and new nodes follow the
/// others.
///
/// The cells at a node are of one part when a way leads from each to each through faces
/// that join two cells and hold the node. Where a change leaves more parts than one, that
/// with the lowest cell keeps the node, and each of the others gets a copy of it.
class CellComplex {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Cells that touch at a node or along an edge alone share their nodes as in the mesh,
  /// until something changes there.
  explicit CellComplex(const Mesh& mesh);

  [[nodiscard]] std::size_t cell_count() const { return cells_.size(); }
  [[nodiscard]] bool is_removed(std::uint32_t cell) const {
    return cells_[cell].size() == 0;
  }
  /// None of a cell that was removed.
  [[nodiscard]] const CellNodes& nodes_of(std::uint32_t cell) const {
    return cells_[cell];
  }
  [[nodiscard]] std::size_t face_count(std::uint32_t cell) const {
    return is_removed(cell) ? 0 : faces(type_of(cells_[cell])).size();
  }
  [[nodiscard]] FaceNodes nodes_of(const CellSide& face) const {
    const CellNodes& cell = cells_[face.cell];
    return face_nodes(cell, faces(type_of(cell))[face.face]);
  }
  /// The cell on the other side of the face, or none.
  [[nodiscard]] std::uint32_t across(const CellSide& face) const {
    return across_[first_face(face.cell) + face.face];
  }
  /// The face with these nodes, as one of its cells has it; there must be one.
  [[nodiscard]] CellSide face_with(const FaceNodes& nodes) const;
  /// The same face as the cell across it has it; there must be one.
  [[nodiscard]] CellSide other_side(const CellSide& face) const;

  /// How many nodes there are, with those that no cell has any more.
  [[nodiscard]] std::size_t node_count() const { return at_nodes_.size(); }
  [[nodiscard]] std::span<const std::uint32_t> cells_at(NodeIndex node) const {
    return std::span(cells_at_nodes_)
        .subspan(at_nodes_[node].first, at_nodes_[node].count);
  }
  /// The node of the mesh that the node is, or is a copy of.
  [[nodiscard]] NodeIndex origin(NodeIndex node) const {
    return node < old_nodes_ ? node : origins_[node - old_nodes_];
  }

  /// Parts the two cells at each of the faces, which must have two.
  void part(std::span<const CellSide> parted);

  /// Removes cells, which must be there.
  void remove(std::span<const std::uint32_t> removed);

 private:
  struct AtNode {
    std::uint32_t first, count;  // in cells_at_nodes_
  };

  [[nodiscard]] std::size_t first_face(std::uint32_t cell) const;
  /// The face of the cell with these nodes, ascending.
  [[nodiscard]] std::optional<CellSide> face_with(std::uint32_t cell,
                                                  const FaceNodes& nodes) const;
  void close(const CellSide& face);
  void separate(std::vector<NodeIndex> nodes);
  void separate(NodeIndex node);

  std::vector<CellNodes> cells_;
  // Cells are sorted by type: of each type, its first cell and that cell's first face.
  std::array<std::uint32_t, 5> first_cells_{};
  std::array<std::size_t, 5> first_faces_{};
  std::vector<std::uint32_t> across_;
  std::vector<AtNode> at_nodes_;
  std::vector<std::uint32_t> cells_at_nodes_;  // of a node ascending, of its copies too
  std::size_t old_nodes_;
  std::vector<NodeIndex> origins_;
};

}  // namespace springcheck
