#include "fem_reference/explicit/hexahedra.hpp"

#include <Eigen/LU>
#include <cmath>

#include "meshing/cell_geometry.hpp"

namespace springcheck::fem_reference {

CornerVectors corner_vectors(const CellNodes& hexahedron, std::span<const Vector3> of) {
  CornerVectors vectors;
  for (std::size_t c = 0; c < 8; ++c)
    vectors.col(static_cast<Eigen::Index>(c)) = of[hexahedron[grid_corners[c]]];
  return vectors;
}

double mode(std::size_t s, const Vector3& xi) {
  double product = 1;
  for (int k = 0; k < 3; ++k)
    if ((s >> k & 1U) != 0) product *= xi[k];
  return product;
}

Vector3 mode_gradient(std::size_t s, const Vector3& xi) {
  Vector3 gradient = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
    if ((s >> k & 1U) != 0) gradient[k] = mode(s & ~(std::size_t{1} << k), xi);
  return gradient;
}

Vector3 corner_place(std::size_t corner) {
  return {(corner & 1U) != 0 ? 1. : -1., (corner & 2U) != 0 ? 1. : -1.,
          (corner & 4U) != 0 ? 1. : -1.};
}

Vector3 gauss_place(std::size_t point) {
  return corner_place(point) / std::sqrt(3.);
}

namespace {

/// dN_a/d xi as columns.
CornerVectors parametric_gradients(const Vector3& xi) {
  CornerVectors gradients = CornerVectors::Zero();
  for (std::size_t a = 0; a < 8; ++a)
    for (std::size_t s = 1; s < 8; ++s)
      gradients.col(static_cast<Eigen::Index>(a)) +=
          mode(s, corner_place(a)) / 8 * mode_gradient(s, xi);
  return gradients;
}

}  // namespace

std::array<GaussPoint, 8> gauss_points(const CornerVectors& rest) {
  std::array<GaussPoint, 8> points;
  for (std::size_t p = 0; p < 8; ++p) {
    const Eigen::Matrix3d jacobian =
        rest * parametric_gradients(gauss_place(p)).transpose();
    points[p] = {.volume = jacobian.determinant(),
                 .inverse_jacobian = jacobian.inverse()};
  }
  return points;
}

CornerVectors shape_gradients(const GaussPoint& at, std::size_t point) {
  return at.inverse_jacobian.transpose() * parametric_gradients(gauss_place(point));
}

OnePointCell one_point_cell(const CornerVectors& rest) {
  OnePointCell cell;
  CornerPositions in_gmsh_order(3, 8);
  for (std::size_t c = 0; c < 8; ++c)
    in_gmsh_order.col(static_cast<Eigen::Index>(grid_corners[c])) =
        rest.col(static_cast<Eigen::Index>(c));
  cell.volume = cell_volume(in_gmsh_order);
  const CornerPositions gradient = cell_volume_gradient(in_gmsh_order);
  for (std::size_t c = 0; c < 8; ++c)
    cell.gradients.col(static_cast<Eigen::Index>(c)) =
        gradient.col(static_cast<Eigen::Index>(grid_corners[c])) / cell.volume;

  const std::array<GaussPoint, 8> points = gauss_points(rest);
  for (Eigen::Index h = 0; h < 4; ++h) {
    const std::size_t s = hourglass_modes[static_cast<std::size_t>(h)];
    Eigen::Matrix<double, 8, 1> signs;
    for (std::size_t a = 0; a < 8; ++a)
      signs[static_cast<Eigen::Index>(a)] = mode(s, corner_place(a));
    cell.hourglass_position.col(h) = rest * signs;
    cell.hourglass_shapes.row(h) =
        (signs - cell.gradients.transpose() * cell.hourglass_position.col(h))
            .transpose() /
        8;
    cell.hourglass_stiffness[h] = 0;
    for (std::size_t p = 0; p < 8; ++p)
      cell.hourglass_stiffness[h] +=
          points[p].volume *
          (points[p].inverse_jacobian.transpose() * mode_gradient(s, gauss_place(p)))
              .squaredNorm();
  }
  return cell;
}

std::array<double, 8> corner_volumes(const CornerVectors& rest) {
  const std::array<GaussPoint, 8> points = gauss_points(rest);
  std::array<double, 8> volumes{};
  for (std::size_t a = 0; a < 8; ++a)
    for (std::size_t p = 0; p < 8; ++p)
      for (std::size_t s = 0; s < 8; ++s)
        volumes[a] +=
            points[p].volume * mode(s, corner_place(a)) * mode(s, gauss_place(p)) / 8;
  return volumes;
}

}  // namespace springcheck::fem_reference
