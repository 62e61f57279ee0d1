#pragma once

#include <vector>

#include "meshing/cell_type.hpp"

namespace springcheck::mss {

/// Local node pairs of a cell's springs (Golec 2018, figures 5.2 and 6.1): its edges,
/// both diagonals of every quadrilateral face, and those of a hexahedron through its
/// inside. The edges are springcheck::edges.
std::vector<LocalEdge> face_diagonals(CellType type);
std::vector<LocalEdge> inner_diagonals(CellType type);

/// The direction a hexahedron's edge runs along: 0 for those that stand like 0-1, 1 like
/// 0-3, 2 like 0-4. A face diagonal gets that of its face's normal.
std::size_t edge_direction(const LocalEdge& edge);
std::size_t face_direction(const LocalEdge& diagonal);

}  // namespace springcheck::mss
