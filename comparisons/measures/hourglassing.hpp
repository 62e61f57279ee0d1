#pragma once

#include <optional>
#include <span>

#include "meshing/mesh.hpp"

namespace springcheck {

/// How much the inside of a body hourglasses: alternates from cell to cell in modes that
/// the cells' mean deformation does not see.
struct Hourglassing {
  // The part of the cells' hourglass displacement that alternates, 0 to 1; none where
  // that displacement is round-off, below 1e-7 of edge length and strain:
  std::optional<double> alternation;
  double amplitude;  // its height over edge length and strain
};

/// Measures how much the inside hourglasses. With
///
///     w_c(n)  displacement of corner n of cell c less the best affine fit (least
///             squares) to those of its eight corners
///     d(n)    mean of w_c(n) over the cells around n
///
/// over the nodes inside the body
///
///     alternation  sum |d|^2 / sum mean |w_c|^2
///     amplitude    rms d / (h e), h the root mean square edge, e that of |E| over the
///                  cells, E Green's strain of the fit
///
/// Rigid motions and homogeneous strain have no w. The hourglass of a bent or twisted
/// cell is not counted: w has the other sign in the cell beyond n, and in d it cancels,
/// to terms of h^4 in fourth derivatives of a smooth field on a regular grid. The
/// hourglass that alternates, u = a (-1)^(i+j), has the same w in all cells around a
/// node: d = u, alternation 1, amplitude a/(h e). A zigzag in one direction, a (-1)^i, is
/// shear or stretch of each cell, and no hourglass.
///
/// Corners and cells count alike, whatever their size: a convention that the amplitude
/// depends on where meshes are irregular.
///
/// There is none on other cells than hexahedra, and without a node inside.
std::optional<Hourglassing> measure_hourglassing(const Mesh& mesh,
                                                 std::span<const Vector3> displacements);

/// The limits above both of which a body hourglasses; set and judged like wrinkled_above.
inline constexpr Hourglassing hourglassing_above{.alternation = 0.5, .amplitude = 0.05};
bool is_hourglassing(const Hourglassing& hourglassing);

}  // namespace springcheck
