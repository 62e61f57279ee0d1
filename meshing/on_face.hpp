#pragma once

#include <span>

#include "meshing/mesh.hpp"

namespace springcheck {

/// Whether the point is within the distance [m] of a place of the face: a triangle's
///
///     a + xi (b - a) + eta (c - a),   xi, eta, 1 - xi - eta >= 0
///
/// or a quadrilateral's, the bilinear one of corners a, b, c, d in xi, eta in [0, 1]. The
/// place nearest to the point is found by Gauss and Newton's method, for triangles and
/// parallelograms in one step.
bool is_on_face(const Vector3& point, const FaceNodes& face,
                std::span<const Vector3> positions, double distance);

}  // namespace springcheck
