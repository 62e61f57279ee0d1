#pragma once

#include <Eigen/Core>

namespace springcheck::tissue {

/// The entries xx, yy, zz, yz, xz, xy of a symmetric tensor, as they are.
using SymmetricTensor = Eigen::Matrix<double, 6, 1>;

inline SymmetricTensor identity() {
  return {1, 1, 1, 0, 0, 0};
}

/// A : B = tr(A B).
inline double contraction(const SymmetricTensor& a, const SymmetricTensor& b) {
  return a.head<3>().dot(b.head<3>()) + 2 * a.tail<3>().dot(b.tail<3>());
}

inline SymmetricTensor adjugate(const SymmetricTensor& a) {
  return {a[1] * a[2] - a[3] * a[3], a[0] * a[2] - a[4] * a[4],
          a[0] * a[1] - a[5] * a[5], a[4] * a[5] - a[0] * a[3],
          a[3] * a[5] - a[1] * a[4], a[3] * a[4] - a[2] * a[5]};
}

inline double determinant(const SymmetricTensor& a) {
  const SymmetricTensor b = adjugate(a);
  return a[0] * b[0] + a[5] * b[5] + a[4] * b[4];
}

inline SymmetricTensor inverse(const SymmetricTensor& a) {
  const SymmetricTensor b = adjugate(a);
  return b / (a[0] * b[0] + a[5] * b[5] + a[4] * b[4]);
}

inline Eigen::Matrix3d matrix_of(const SymmetricTensor& a) {
  return (Eigen::Matrix3d() << a[0], a[5], a[4], a[5], a[1], a[3], a[4], a[3], a[2])
      .finished();
}

inline SymmetricTensor symmetric_tensor(const Eigen::Matrix3d& a) {
  return {a(0, 0), a(1, 1), a(2, 2), a(1, 2), a(0, 2), a(0, 1)};
}

}  // namespace springcheck::tissue
