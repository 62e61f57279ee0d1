#include "mss/cell.hpp"

namespace springcheck::mss {
namespace {

/// Side of the cell each corner is on, along its three directions.
const Eigen::Matrix<double, 3, 8> corner_signs =
    (Eigen::Matrix<double, 3, 8>() << -1, 1, 1, -1, -1, 1, 1, -1,  //
     -1, -1, 1, 1, -1, -1, 1, 1,                                   //
     -1, -1, -1, -1, 1, 1, 1, 1)
        .finished();

Eigen::Matrix3d cross_product_matrix(const Vector3& a) {
  return (Eigen::Matrix3d() << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0)
      .finished();
}

}  // namespace

Eigen::Matrix3d mean_edges(const CornerPositions& x) {
  Eigen::Matrix3d edges = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < 8; ++i)
    edges += x.col(i) * corner_signs.col(i).transpose() / 4;
  return edges;
}

double mean_edge_volume(const CornerPositions& x) {
  return mean_edges(x).determinant();
}

Eigen::Matrix<double, 3, 8> mean_edge_volume_gradient(const CornerPositions& x) {
  const Eigen::Matrix3d edges = mean_edges(x);
  const Vector3 X = edges.col(0), Y = edges.col(1), Z = edges.col(2);
  Eigen::Matrix3d areas;
  areas << Y.cross(Z), Z.cross(X), X.cross(Y);
  return areas * corner_signs / 4;
}

Eigen::Matrix<double, 24, 24> mean_edge_volume_hessian(const CornerPositions& x) {
  const Eigen::Matrix3d edges = mean_edges(x);
  const Eigen::Matrix3d by_x = cross_product_matrix(edges.col(0)),
                        by_y = cross_product_matrix(edges.col(1)),
                        by_z = cross_product_matrix(edges.col(2));
  Eigen::Matrix<double, 24, 24> hessian;
  for (Eigen::Index i = 0; i < 8; ++i)
    for (Eigen::Index j = 0; j < 8; ++j) {
      const Vector3 s = corner_signs.col(i), t = corner_signs.col(j);
      // V is the determinant of (X, Y, Z): its second derivative pairs two different
      // edge vectors, det(., ., Z) and its cyclic sisters.
      hessian.block<3, 3>(3 * i, 3 * j) = -((s.x() * t.y() - s.y() * t.x()) * by_z +
                                            (s.y() * t.z() - s.z() * t.y()) * by_x +
                                            (s.z() * t.x() - s.x() * t.z()) * by_y) /
                                          16;
    }
  return hessian;
}

}  // namespace springcheck::mss
