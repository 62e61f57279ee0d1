#include "meshing/on_face.hpp"

#include <algorithm>

namespace springcheck {

bool is_on_face(const Vector3& point, const FaceNodes& face,
                std::span<const Vector3> positions, double distance) {
  const Vector3 &a = positions[face[0]], &b = positions[face[1]];
  const bool is_triangle = face.size() == 3;
  const Vector3& d = positions[face[is_triangle ? 2 : 3]];  // at xi = 0, eta = 1
  const Vector3 twist =
      is_triangle ? Vector3(Vector3::Zero()) : Vector3(a - b + positions[face[2]] - d);
  Eigen::Vector2d place = Eigen::Vector2d::Constant(is_triangle ? 1. / 3 : 0.5);
  const auto offset = [&] {
    return Vector3(a + place[0] * (b - a) + place[1] * (d - a) +
                   place[0] * place[1] * twist - point);
  };
  constexpr int steps = 10;  // quadratic convergence where the point is on the face
  for (int step = 0; step < steps; ++step) {
    Eigen::Matrix<double, 3, 2> tangents;
    tangents.col(0) = b - a + place[1] * twist;
    tangents.col(1) = d - a + place[0] * twist;
    const Eigen::Matrix2d normal_matrix = tangents.transpose() * tangents;
    place -= normal_matrix.inverse() * (tangents.transpose() * offset());
    place = place.cwiseMax(-1).cwiseMin(2);  // far off the face the steps may run away
  }
  // Back onto the face, if only by what the distance allows:
  place = place.cwiseMax(0).cwiseMin(1);
  if (is_triangle && place.sum() > 1) place.array() -= (place.sum() - 1) / 2;
  return offset().norm() <= distance;  // false for the not-a-number of a flat face
}

}  // namespace springcheck
