#pragma once

#include <array>
#include <span>

#include "meshing/mesh.hpp"

namespace springcheck {

using HexahedronCorners = std::array<Vector3, 8>;

/// Positions of a cell's eight nodes.
HexahedronCorners corners(const Hexahedron& cell, std::span<const Vector3> positions);

/// Exact volume of the trilinear hexahedron [m^3], negative when turned inside out.
///
/// By the divergence theorem over its bilinear faces, per outward face (a, b, c, d):
///
///     V += [a.(b x c) + a.(c x d) + a.(b x d) + b.(c x d)] / 12
///
/// Source: integration of x.n/3 over the bilinear patch; exact for any node positions.
double trilinear_volume(const HexahedronCorners& x);

/// Smallest of the eight corner Jacobians: det of the three edge vectors that leave a
/// corner, [m^3]; h^3 for a cube of edge h. Negative: the map folds over at a corner.
double smallest_corner_jacobian(const HexahedronCorners& x);

/// The six faces of a hexahedron as local node numbers, right-handed about the
/// outward normal.
inline constexpr std::array<std::array<int, 4>, 6> hexahedron_faces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 4, 7, 3}, {1, 2, 6, 5}}};

/// Exact trilinear volume of each cell with its nodes at `positions`.
std::vector<double> cell_volumes(std::span<const Hexahedron> cells,
                                 std::span<const Vector3> positions);

}  // namespace springcheck
