#include "mss/networks/deformation.hpp"

namespace springcheck::mss {
namespace {

Matrix3 cross_product_matrix(const Vector3& a) {
  return (Matrix3() << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0).finished();
}

}  // namespace

double volume_change(const Matrix3& H) {
  const double trace = H.trace();
  return trace + (trace * trace - (H * H).trace()) / 2 + H.determinant();
}

Matrix3 cofactor(const Matrix3& H) {
  const Matrix3 F = Matrix3::Identity() + H;
  Matrix3 areas;
  areas << F.col(1).cross(F.col(2)), F.col(2).cross(F.col(0)), F.col(0).cross(F.col(1));
  return areas;
}

Matrix9 volume_hessian(const Matrix3& H) {
  const Matrix3 F = Matrix3::Identity() + H;
  Matrix9 hessian = Matrix9::Zero();
  // The determinant's second derivative pairs two different columns, det(., ., F_3) and
  // its cyclic sisters.
  for (Eigen::Index J = 0; J < 3; ++J) {
    const Eigen::Index K = (J + 1) % 3, L = (J + 2) % 3;
    const Matrix3 across = cross_product_matrix(F.col(L));
    hessian.block<3, 3>(3 * J, 3 * K) = -across;
    hessian.block<3, 3>(3 * K, 3 * J) = across;
  }
  return hessian;
}

double volume_change(StrainMeasure measure, const Matrix3& H) {
  if (measure == StrainMeasure::green) return H.trace() + H.squaredNorm() / 2;
  return volume_change(H);
}

Matrix3 volume_gradient(StrainMeasure measure, const Matrix3& H) {
  if (measure == StrainMeasure::green) return Matrix3::Identity() + H;
  return cofactor(H);
}

Matrix9 volume_hessian(StrainMeasure measure, const Matrix3& H) {
  if (measure == StrainMeasure::green) return Matrix9::Identity();
  return volume_hessian(H);
}

}  // namespace springcheck::mss
