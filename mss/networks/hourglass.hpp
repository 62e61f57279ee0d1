#pragma once

#include <vector>

#include "meshing/cell_geometry.hpp"
#include "meshing/loads/scene.hpp"
#include "mss/networks/cells.hpp"

namespace springcheck::mss {

/// Springs against the deformations of a cell that its mean F does not see, with the
/// energy k/2 (|d| - |F r|)^2: zero in every affine state, never negative. V is the
/// cell's volume, l the spring's length, k = eta E V/l^2, and
///
///     hexahedron, pyramid  edges eta = [(1 + sqrt(1 + 4 m^2))/2 - m]/12, face diagonals
///                          eta = m/3 with m = .843/(2(1 + nu))
///     prism                edges of the triangles eta = 1/6; diagonals of the
///                          quadrilaterals k = .6 mu V l^2/(6 h^2 a^2); edges between the
///                          triangles k = max(0, E V/(12 h^2) - .05 mu V/a^2)
///     tetrahedron          none
///
/// a and h are the means of the triangles' sides and of the edges between them.
/// Source: own. m fits bending and torsion of hexahedra; the constants of prisms were
/// tried for h/a up to 1.8.
std::vector<CellSpring> hourglass_springs(const CornerPositions& x, double volume,
                                          const Material& material);

}  // namespace springcheck::mss
