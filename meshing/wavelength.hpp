#pragma once

#include <span>

#include "meshing/mesh.hpp"

namespace springcheck {

/// Wavelength of a vector field on the nodes, in edges of the cells, along the direction
/// in which it is shortest: at least 2.
///
/// The cells' edges are sorted by direction, each to the nearest of the 13 from a cube's
/// centre to its faces, edges and corners. Over those of a direction the correlation
///
///     rho = sum f_a.f_b / (1/2 sum (|f_a|^2 + |f_b|^2))
///
/// is cos(2 pi h/L) of a wave of length L along edges of length h: L/h = 2 pi/acos(rho).
/// A direction counts where it has at least half as many edges as the one with most; the
/// same between edges of different lengths in units of their own. Below 4 where
/// neighbours pull in opposite ways.
double shortest_wavelength(std::span<const CellNodes> cells,
                           std::span<const Vector3> nodes,
                           std::span<const Vector3> field);

}  // namespace springcheck
