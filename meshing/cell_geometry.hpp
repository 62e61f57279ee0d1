#pragma once

#include <span>
#include <vector>

#include "meshing/basics/vector3.hpp"
#include "meshing/cell_type.hpp"

namespace springcheck {

/// Positions of a cell's nodes as columns, four to eight of them.
using CornerPositions = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 8>;

CellType type_of(const CornerPositions& x);

/// The vector from the first of two corners to the second [m].
inline Vector3 along(const CornerPositions& x, const LocalEdge& ends) {
  return x.col(static_cast<Eigen::Index>(ends[1])) -
         x.col(static_cast<Eigen::Index>(ends[0]));
}

CornerPositions corners(const CellNodes& cell, std::span<const Vector3> positions);

/// Exact volume of a cell with straight edges and bilinear quadrilateral faces [m^3],
/// negative when turned inside out. By the divergence theorem, per outward face (a, b, c)
/// or (a, b, c, d):
///
///     V += a.(b x c) / 6
///     V += [a.(b x c) + a.(c x d) + a.(b x d) + b.(c x d)] / 12
///
/// Source: integration of x.n/3 over the triangle and over the bilinear patch; exact for
/// any node positions.
double cell_volume(const CornerPositions& x);

/// The gradient of cell_volume by the corners' positions, one column per corner [m^2].
/// Each face adds, at (a, b, c) and cyclic,
///
///     dV/da += (b x c) / 6
///     dV/da += (b x c + c x d + b x d) / 12
///
/// and sum x_a (x) dV/dx_a = V I.
CornerPositions cell_volume_gradient(const CornerPositions& x);

/// The centroid c [m] of a cell, by the divergence theorem:
///
///     V c_i = integral of x_i^2/2 n_i over the faces
///
/// (no sum), exactly over triangles and by 2 x 2 Gauss points per bilinear quadrilateral,
/// which are exact for it: x_i^2 n_i dA is of third degree in each parameter. It is of
/// use for V > 0 only.
Vector3 cell_centroid(const CornerPositions& x);

/// The smallest of the corner Jacobians, each the determinant of the three edge vectors
/// that leave a corner [m^3]; h^3 for a cube of edge h. A pyramid's apex has four edges
/// and no Jacobian. It is negative where the map folds over at a corner.
double smallest_corner_jacobian(const CornerPositions& x);

/// Whether a cell is turned inside out at a corner, or flat there.
bool has_inverted_cell(std::span<const CellNodes> cells,
                       std::span<const Vector3> positions);

/// Exact volume of each cell with its nodes at `positions`.
std::vector<double> cell_volumes(std::span<const CellNodes> cells,
                                 std::span<const Vector3> positions);

}  // namespace springcheck
