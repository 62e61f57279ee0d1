#include "statics/systems/chebyshev.hpp"

#include <algorithm>
#include <cmath>

namespace springcheck::statics {
namespace {

constexpr int degree = 3;
constexpr double smoothed_part = 30;  // of the bound: largest over smallest

}  // namespace

Chebyshev::Chebyshev(const RowMatrix& matrix)
    : inverse_diagonal_(matrix.diagonal()), bound_(0) {
  // An aggregate whose nodes are held lacks motions, and their rows are empty.
  for (double& entry : inverse_diagonal_) entry = entry > 0 ? 1 / entry : 0;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    double sum = 0;
    for (RowMatrix::InnerIterator entry(matrix, row); entry; ++entry)
      sum += std::abs(entry.value());
    bound_ = std::max(bound_, sum * inverse_diagonal_[row]);
  }
}

Eigen::VectorXd Chebyshev::from_zero(const RowMatrix& matrix,
                                     const Eigen::VectorXd& right) const {
  const double upper = bound_, lower = bound_ / smoothed_part;
  const double centre = (upper + lower) / 2, half_width = (upper - lower) / 2;
  double rho = half_width / centre;
  Eigen::VectorXd residual = right;
  Eigen::VectorXd step = inverse_diagonal_.cwiseProduct(residual) / centre;
  Eigen::VectorXd x = step;
  for (int i = 1; i < degree; ++i) {
    residual -= product(matrix, step);
    const double next = 1 / (2 * centre / half_width - rho);
    step = next * rho * step +
           2 * next / half_width * inverse_diagonal_.cwiseProduct(residual);
    rho = next;
    x += step;
  }
  return x;
}

}  // namespace springcheck::statics
