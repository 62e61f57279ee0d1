#include "comparisons/modes/free_block_modes.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace springcheck {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using Degrees = std::array<int, 3>;  // of a product of polynomials in x, y, z

std::vector<Degrees> products_up_to(int degree) {
  std::vector<Degrees> all;
  for (int x = 0; x <= degree; ++x)
    for (int y = 0; x + y <= degree; ++y)
      for (int z = 0; x + y + z <= degree; ++z) all.push_back({x, y, z});
  return all;
}

/// The integral int p_m p_n' dx of Legendre polynomials that are orthonormal on [0, L]:
///
///     2/L sqrt((2m + 1)(2n + 1)) where n - m is positive and odd, else 0
double with_derivative(int m, int n, double length) {
  const bool is_some = n > m && (n - m) % 2 == 1;
  return is_some ? 2 / length * std::sqrt((2. * m + 1) * (2. * n + 1)) : 0;
}

/// Integrals of products of derivatives over the block.
class Integrals {
 public:
  Integrals(const std::array<double, 3>& size, int degree) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      MatrixXd& D = with_derivative_[axis];
      D.resize(degree + 1, degree + 1);
      for (int m = 0; m <= degree; ++m)
        for (int n = 0; n <= degree; ++n) D(m, n) = with_derivative(m, n, size[axis]);
      // p_n' is the sum of D_mn p_m.
      derivatives_[axis] = D.transpose() * D;
    }
  }

  /// The integral int d_i a d_j b dV.
  [[nodiscard]] double of(const Degrees& a, std::size_t i, const Degrees& b,
                          std::size_t j) const {
    double product = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (axis == i && axis == j)
        product *= derivatives_[axis](a[axis], b[axis]);
      else if (axis == i)
        product *= with_derivative_[axis](b[axis], a[axis]);
      else if (axis == j)
        product *= with_derivative_[axis](a[axis], b[axis]);
      else if (a[axis] != b[axis])
        return 0;
    return product;
  }

 private:
  std::array<MatrixXd, 3> with_derivative_, derivatives_;
};

/// The stiffness matrix of the basis a e_i, with entries 3 a + i.
MatrixXd stiffness(const std::vector<Degrees>& basis, const Integrals& integrals,
                   const LameConstants& lame) {
  const auto count = static_cast<Index>(basis.size());
  MatrixXd K(3 * count, 3 * count);
  for (Index a = 0; a < count; ++a)
    for (Index b = 0; b < count; ++b) {
      const auto of = [&](std::size_t i, std::size_t j) {
        return integrals.of(basis[static_cast<std::size_t>(a)], i,
                            basis[static_cast<std::size_t>(b)], j);
      };
      const double gradients = of(0, 0) + of(1, 1) + of(2, 2);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          K(3 * a + static_cast<Index>(i), 3 * b + static_cast<Index>(j)) =
              lame.lambda * of(i, j) + lame.mu * (of(j, i) + (i == j ? gradients : 0));
    }
  return K;
}

/// Values of the basis at the points, (point, function).
MatrixXd values(const std::vector<Degrees>& basis, const std::array<double, 3>& size,
                const std::vector<Vector3>& points) {
  MatrixXd at(points.size(), basis.size());
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t a = 0; a < basis.size(); ++a) {
      double product = 1;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto n = static_cast<unsigned int>(basis[a][axis]);
        const double L = size[axis], x = points[p][static_cast<Index>(axis)];
        product *= std::sqrt((2 * n + 1) / L) * std::legendre(n, 2 * x / L - 1);
      }
      at(static_cast<Index>(p), static_cast<Index>(a)) = product;
    }
  return at;
}

}  // namespace

NaturalModes free_block_modes(const std::array<double, 3>& size, const Material& material,
                              int degree, int count, const std::vector<Vector3>& points) {
  constexpr Index rigid = 6;
  const std::vector<Degrees> basis = products_up_to(degree);
  // The basis is orthonormal: masses are rho I.
  const Eigen::SelfAdjointEigenSolver<MatrixXd> spectrum(
      stiffness(basis, Integrals(size, degree), lame_constants(material)) /
      material.density);
  NaturalModes modes{
      .zero_modes = rigid,
      .frequencies = spectrum.eigenvalues().segment(rigid, count).cwiseSqrt() /
                     (2 * std::numbers::pi),
      .shapes = MatrixXd(3 * points.size(), count)};
  const MatrixXd at = values(basis, size, points);
  for (Index mode = 0; mode < count; ++mode) {
    const VectorXd coefficients =
        spectrum.eigenvectors().col(rigid + mode) / std::sqrt(material.density);
    const MatrixXd shape =
        coefficients.reshaped(3, at.cols()) * at.transpose();  // a point a column
    modes.shapes.col(mode) = shape.reshaped();
  }
  return modes;
}

}  // namespace springcheck
