#pragma once

#include <array>
#include <span>
#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck {

// Cuts of one hexahedron. Where a face is cut, its diagonal runs through the smallest of
// its node numbers, so that both cells at a face agree; "even" and "odd" hexahedra agree
// in turn. In the cuts that name no number this needs node 0 to be the smallest of each
// face it belongs to, as on a grid numbered lexicographically.

/// Two prisms with their triangles across the axis: 0 for x, the way from node 0 to 1; 1
/// for y, to 3; 2 for z, to 4.
std::vector<CellNodes> prisms_along(std::size_t axis, const CellNodes& hexahedron);

/// Six tetrahedra around the diagonal 0-6, three in each of the prisms along z.
/// Source: Kuhn's triangulation of the cube.
std::vector<CellNodes> six_tetrahedra(const CellNodes& hexahedron);

/// One tetrahedron amid four at the corners 1, 3, 4, 6 (even) or 0, 2, 5, 7 (odd).
std::vector<CellNodes> five_tetrahedra(const CellNodes& hexahedron, bool is_even);

/// Mean of its corners.
Vector3 mean_of(const CellNodes& hexahedron, std::span<const Vector3> nodes);

/// Over each face a pyramid, or two tetrahedra where the face is cut, to the centre.
std::vector<CellNodes> cells_around(NodeIndex centre, const CellNodes& hexahedron,
                                    const std::array<bool, 6>& is_cut);

}  // namespace springcheck
