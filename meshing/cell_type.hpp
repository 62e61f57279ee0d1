#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "meshing/short_list.hpp"

namespace springcheck {

/// Index into Mesh::nodes(); the same in both solvers and in every file written.
using NodeIndex = std::uint32_t;

/// Nodes of a cell in gmsh's order (VTK's too, but for prisms). Their number tells the
/// type.
///
///     tetrahedron  0-1-2 right-handed about the normal that points to 3
///     pyramid      0-1-2-3 around the base, right-handed about the way to the apex 4
///     prism        0-1-2 right-handed about the way to 3-4-5, which lie above them
///     hexahedron   0-1-2-3 likewise, 4-5-6-7 above them
using CellNodes = ShortList<NodeIndex, 8>;

/// Three or four nodes of a face, right-handed about the outward normal.
using FaceNodes = ShortList<NodeIndex, 4>;

enum class CellType : std::uint8_t { tetrahedron, pyramid, prism, hexahedron };

inline constexpr std::array all_cell_types{CellType::tetrahedron, CellType::pyramid,
                                           CellType::prism, CellType::hexahedron};

/// A cell's own node numbers, from 0.
using LocalEdge = std::array<std::size_t, 2>;
using LocalFace = ShortList<std::uint8_t, 4>;

/// The places in CellNodes of a hexahedron's corners in the order of a grid, x fastest.
inline constexpr std::array<std::uint8_t, 8> grid_corners{0, 1, 3, 2, 4, 5, 7, 6};

std::string_view name_of(CellType type);
std::string_view plural_of(CellType type);  // "tetrahedra"
std::size_t node_count(CellType type);

/// The type with so many nodes, which must be 4, 5, 6 or 8.
CellType type_with(std::size_t nodes);
inline CellType type_of(const CellNodes& cell) {
  return type_with(cell.size());
}

std::span<const LocalEdge> edges(CellType type);

/// The faces of a cell, right-handed about the outward normal.
std::span<const LocalFace> faces(CellType type);

/// The same nodes, the smallest first: equal for both cells at a face.
FaceNodes ascending(FaceNodes face);

/// The cell's nodes at one of its faces.
FaceNodes face_nodes(const CellNodes& cell, const LocalFace& face);

/// Corners with the ends of their three edges, right-handed: all corners but a pyramid's
/// apex, where four edges meet; of a tetrahedron one, as they all span the same volume.
using CornerPatch = std::array<std::uint8_t, 4>;
std::span<const CornerPatch> corner_patches(CellType type);

}  // namespace springcheck
