#include "mss/tissue/tissue_cell.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cmath>

namespace springcheck::mss {
namespace {

using Eigen::Index;
using tissue::SymmetricTensor;

constexpr std::array<std::array<int, 2>, 6> places{
    {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

Matrix3 cofactor_of(const Matrix3& F) {
  Matrix3 cofactor;
  cofactor << F.col(1).cross(F.col(2)), F.col(2).cross(F.col(0)),
      F.col(0).cross(F.col(1));
  return cofactor;
}

bool has_hourglasses(const TissueShape& shape) {
  return shape.gradients.cols() > 4;
}

/// dC/dx: the entries of C by the positions.
Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 24> strain_operator(
    const TissueShape& shape, const Matrix3& F) {
  const CornerPositions& G = shape.gradients;
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 24> B(6, 3 * G.cols());
  for (Index a = 0; a < G.cols(); ++a)
    for (Index entry = 0; entry < 6; ++entry) {
      const auto [j, k] = places[static_cast<std::size_t>(entry)];
      B.block<1, 3>(entry, 3 * a) = (G(j, a) * F.col(k) + G(k, a) * F.col(j)).transpose();
    }
  return B;
}

/// Minus the forces' derivative by the six entries of the strands' S.
Eigen::Matrix<double, Eigen::Dynamic, 6, 0, 24, 6> by_strands(const TissueShape& shape,
                                                              const CornerPositions& x,
                                                              const Matrix3& F) {
  const CornerPositions& G = shape.gradients;
  Eigen::Matrix<double, Eigen::Dynamic, 6, 0, 24, 6> change(3 * G.cols(), 6);
  CornerPositions bent = CornerPositions::Zero(3, G.cols());
  if (has_hourglasses(shape))
    bent = hourglass_length(shape.volume) / 3 * x * shape.hourglasses;
  for (Index entry = 0; entry < 6; ++entry) {
    const auto [j, k] = places[static_cast<std::size_t>(entry)];
    CornerPositions by = shape.volume * F.col(j) * G.row(k);
    if (j == k)
      by += bent;
    else
      by += shape.volume * F.col(k) * G.row(j);
    change.col(entry) = by.reshaped();
  }
  return change;
}

}  // namespace

double hourglass_length(double volume) {
  return std::cbrt(volume) / 2;
}

TissueShape tissue_shape(const CornerPositions& rest) {
  TissueShape shape{.volume = cell_volume(rest), .gradients = {}, .hourglasses = {}};
  shape.gradients = cell_volume_gradient(rest) / shape.volume;
  const Index n = rest.cols();
  shape.hourglasses.setZero(n, n);
  if (!has_hourglasses(shape)) return shape;
  // The functions are taken about the nodes' mean and in units of the cell's own length,
  // so that the matrix is well conditioned.
  Eigen::Matrix<double, Eigen::Dynamic, 4> affine(n, 4);
  affine.col(0).setOnes();
  affine.rightCols<3>() =
      ((rest.colwise() - rest.rowwise().mean()) / std::cbrt(shape.volume)).transpose();
  const Eigen::Matrix4d inverse = (affine.transpose() * affine).inverse();
  shape.hourglasses =
      Eigen::MatrixXd::Identity(n, n) - affine * inverse * affine.transpose();
  return shape;
}

Matrix3 mean_deformation_gradient(const TissueShape& shape, const CornerPositions& x) {
  return x * shape.gradients.transpose();
}

SymmetricTensor right_cauchy_green(const TissueShape& shape, const CornerPositions& x) {
  const Matrix3 F = mean_deformation_gradient(shape, x);
  return tissue::symmetric_tensor(F.transpose() * F);
}

SymmetricTensor right_cauchy_green_rate(const TissueShape& shape,
                                        const CornerPositions& x,
                                        const CornerPositions& v) {
  const Matrix3 half = mean_deformation_gradient(shape, x).transpose() *
                       mean_deformation_gradient(shape, v);
  return tissue::symmetric_tensor(half + half.transpose());
}

CornerPositions tissue_forces(const TissueShape& shape, const CornerPositions& x,
                              const tissue::PointStress& stress) {
  const Matrix3 F = mean_deformation_gradient(shape, x);
  CornerPositions forces =
      -shape.volume *
      (F * tissue::matrix_of(stress.strands) + stress.volume * cofactor_of(F)) *
      shape.gradients;
  if (has_hourglasses(shape)) {
    const double mean = stress.strands.head<3>().sum() / 3;
    forces -= hourglass_length(shape.volume) * mean * x * shape.hourglasses;
  }
  return forces;
}

TissueStiffness tissue_stiffness(const TissueShape& shape, const CornerPositions& x,
                                 const tissue::PointStress& stress,
                                 const tissue::PointTangent& tangent) {
  const Matrix3 F = mean_deformation_gradient(shape, x);
  const CornerPositions& G = shape.gradients;
  const double V = shape.volume;
  const double hourglass =
      hourglass_length(shape.volume) * stress.strands.head<3>().sum() / 3;
  TissueStiffness K = TissueStiffness::Zero(3 * G.cols(), 3 * G.cols());

  // One part is that at the springs' stiffness and at the volume stress: V v F (G_a x
  // G_b) x dx_b.
  const CornerPositions SG = tissue::matrix_of(stress.strands) * G;
  for (Index a = 0; a < G.cols(); ++a)
    for (Index b = 0; b < G.cols(); ++b) {
      const double spring =
          V * G.col(a).dot(SG.col(b)) + hourglass * shape.hourglasses(a, b);
      const Vector3 w = V * stress.volume * F * G.col(a).cross(G.col(b));
      K.block<3, 3>(3 * a, 3 * b) = (Matrix3() << spring, w.z(), -w.y(), -w.z(), spring,
                                     w.x(), w.y(), -w.x(), spring)
                                        .finished();
    }

  // The other part is by the change of both.
  const CornerPositions by_volume = V * cofactor_of(F) * G;
  K += (by_strands(shape, x, F) * tangent.strands +
        by_volume.reshaped() * tangent.volume.transpose()) *
       strain_operator(shape, F);
  return K;
}

}  // namespace springcheck::mss
