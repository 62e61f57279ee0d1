#include "statics/systems/chebyshev.hpp"

#include <random>

#include "meshing/random_vector.hpp"

namespace springcheck::statics {
namespace {

constexpr int degree = 3;
constexpr double smoothed_part = 15;  // of the spectrum: largest over smallest
constexpr int power_steps = 10;
constexpr double margin = 1.1;

}  // namespace

Chebyshev::Chebyshev(const RowMatrix& matrix)
    : inverse_diagonal_(matrix.diagonal().cwiseInverse()), largest_(0) {
  std::mt19937_64 random(1);
  Eigen::VectorXd v = random_vector(matrix.rows(), random).normalized();
  for (int i = 0; i < power_steps; ++i) {
    v = inverse_diagonal_.cwiseProduct(product(matrix, v));
    largest_ = margin * v.norm();
    v.normalize();
  }
}

Eigen::VectorXd Chebyshev::from_zero(const RowMatrix& matrix,
                                     const Eigen::VectorXd& right) const {
  const double upper = largest_, lower = largest_ / smoothed_part;
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
