#pragma once

#include <array>
#include <map>

#include "meshing/cell_geometry.hpp"
#include "meshing/mesh.hpp"

namespace springcheck {

/// How far a cell is from the regular one of its type, which has 1 [-]:
///
///     J = min over corners of det(a, b, c) / (|a| |b| |c|) / J_regular
///
/// a, b, c the edges that leave the corner. J_regular is 1/sqrt(2) for a tetrahedron and
/// a pyramid whose edges are all equal, sqrt(3)/2 for a prism and 1 for a hexahedron. At
/// a pyramid's apex, where four edges meet, each three consecutive ones count as a
/// corner's; they have the same J_regular. J is 0 or less where a cell is flat or folded
/// over.
///
/// Source: the scaled Jacobian of Knupp, SIAM J. Sci. Comput. 23 (2001) 193, extended to
/// the other types by J_regular.
double scaled_jacobian(const CornerPositions& x);

/// Longest edge over the shortest one [-].
double edge_ratio(const CornerPositions& x);

/// The quality of the cells of one type, or of all.
struct CellQuality {
  std::size_t cells;
  double volume;  // [m^3] of all together
  double smallest_volume;
  double mean_volume;
  double largest_volume;
  double smallest_scaled_jacobian;
  double mean_scaled_jacobian;
  double largest_edge_ratio;
  double mean_edge_ratio;
  // Cells with a scaled Jacobian in [0, 0.1), [0.1, 0.2), ..., [0.9, 1]:
  std::array<std::size_t, 10> histogram{};
};

struct Quality {
  CellQuality all;
  std::map<CellType, CellQuality> by_type{};  // those there are
};
Quality quality_of(const Mesh& mesh);

}  // namespace springcheck
