#include "mss/networks/deformation.hpp"

#include <numbers>

namespace springcheck::mss {
namespace {

/// The icosahedron's axes as columns: (phi, 1, 0), (phi, -1, 0) and cyclic, normalised.
const Eigen::Matrix<double, 3, 6> axes = [] {
  Eigen::Matrix<double, 3, 6> n = Eigen::Matrix<double, 3, 6>::Zero();
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    for (const Eigen::Index side : {0, 1}) {
      n(axis, 2 * axis + side) = std::numbers::phi;
      n((axis + 1) % 3, 2 * axis + side) = side == 0 ? 1 : -1;
    }
  return Eigen::Matrix<double, 3, 6>(n.colwise().normalized());
}();

/// Calls visit(n, d, |d|, |d| - 1) for each axis; the elongation from H, to keep the
/// digits of small strains.
template <class Visit>
void for_each_axis(const Matrix3& H, Visit&& visit) {
  const Eigen::Matrix<double, 3, 6> moves = H * axes;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const Vector3 n = axes.col(i), d = n + moves.col(i);
    const double length = d.norm();
    visit(n, d, length, (n + d).dot(moves.col(i)) / (length + 1));
  }
}

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

Eigen::Vector<double, 6> axis_strains(const Matrix3& H) {
  Eigen::Vector<double, 6> strains;
  Eigen::Index axis = 0;
  for_each_axis(H, [&](const Vector3&, const Vector3&, double, double elongation) {
    strains[axis++] = elongation;
  });
  return strains;
}

double VirtualSprings::energy(const Matrix3& H) const {
  double energy = 0;
  if (shear_modulus != 0)
    for_each_axis(H, [&](const Vector3&, const Vector3&, double, double elongation) {
      energy += 5 * shear_modulus / 4 * elongation * elongation;
    });
  if (volume_modulus != 0) {
    const double change = volume_change(H);
    energy += volume_modulus / 2 * change * change;
  }
  return energy;
}

Matrix3 VirtualSprings::stress(const Matrix3& H) const {
  Matrix3 P = Matrix3::Zero();
  if (shear_modulus != 0)
    for_each_axis(
        H, [&](const Vector3& n, const Vector3& d, double length, double elongation) {
          if (length == 0) return;
          P += (5 * shear_modulus / 2 * elongation / length * d) * n.transpose();
        });
  if (volume_modulus != 0) P += volume_modulus * volume_change(H) * cofactor(H);
  return P;
}

Matrix9 VirtualSprings::tangent(const Matrix3& H) const {
  Matrix9 A = Matrix9::Zero();
  if (shear_modulus != 0)
    for_each_axis(
        H, [&](const Vector3& n, const Vector3& d, double length, double elongation) {
          if (length == 0) return;
          const Matrix3 block = 5 * shear_modulus / 2 *
                                (elongation / length * Matrix3::Identity() +
                                 d * d.transpose() / (length * length * length));
          for (Eigen::Index J = 0; J < 3; ++J)
            for (Eigen::Index L = 0; L < 3; ++L)
              A.block<3, 3>(3 * J, 3 * L) += n[J] * n[L] * block;
        });
  if (volume_modulus != 0) {
    const Matrix3 area = cofactor(H);
    A += volume_modulus * (area.reshaped() * area.reshaped().transpose() +
                           volume_change(H) * volume_hessian(H));
  }
  return A;
}

}  // namespace springcheck::mss
