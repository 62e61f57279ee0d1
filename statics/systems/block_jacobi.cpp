#include "statics/systems/block_jacobi.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>

namespace springcheck::statics {

void BlockJacobi::prepare(const BlockMatrix& matrix) {
  inverses_.resize(matrix.nodes());
  tbb::parallel_for(
      NodeIndex{0}, static_cast<NodeIndex>(matrix.nodes()), [&](NodeIndex n) {
        Matrix3 block = matrix.diagonal(n);
        for (int i = 0; i < 3; ++i)
          if (unknowns_.of(n, i) < 0) {
            block.row(i).setZero();
            block.col(i).setZero();
            block(i, i) = 1;
          }
        const Eigen::SelfAdjointEigenSolver<Matrix3> spectrum(block);
        const Vector3 sizes = spectrum.eigenvalues().cwiseAbs();
        const double least = 1e-12 * sizes.maxCoeff();
        const Matrix3& axes = spectrum.eigenvectors();
        inverses_[n] =
            axes * sizes.cwiseMax(least).cwiseInverse().asDiagonal() * axes.transpose();
      });
}

Eigen::VectorXd BlockJacobi::times(const Eigen::VectorXd& residual) const {
  Eigen::VectorXd z(residual.size());
  for (std::size_t n = 0; n < inverses_.size(); ++n) {
    const auto row = 3 * static_cast<Eigen::Index>(n);
    z.segment<3>(row).noalias() = inverses_[n] * residual.segment<3>(row);
  }
  return z;
}

}  // namespace springcheck::statics
