#pragma once

#include <Eigen/Eigenvalues>

namespace springcheck::statics {

/// A symmetric matrix with its negative eigenvalues set to zero.
template <class Matrix>
Matrix positive_part(const Matrix& matrix) {
  const Eigen::SelfAdjointEigenSolver<Matrix> spectrum(matrix);
  const Matrix& vectors = spectrum.eigenvectors();
  return vectors * spectrum.eigenvalues().cwiseMax(0).asDiagonal() * vectors.transpose();
}

}  // namespace springcheck::statics
