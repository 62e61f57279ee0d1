#include "meshing/natural_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "meshing/sparse_cholesky.hpp"

namespace springcheck {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

constexpr Index block_size = 12;
constexpr double shift_of_largest = 1e-6, zero_of_largest = 1e-9;

/// x -> (K + s M)^-1 M x, whose eigenvalues are 1/(omega^2 + s).
class ShiftedInverse {
 public:
  ShiftedInverse(const SparseMatrix& stiffness, const SparseMatrix& masses, double shift)
      : masses_(masses), exists_(cholesky_.factor(stiffness + shift * masses)) {}

  [[nodiscard]] bool exists() const { return exists_; }
  [[nodiscard]] MatrixXd weighed(const MatrixXd& x) const {
    return masses_.selfadjointView<Eigen::Lower>() * x;
  }
  [[nodiscard]] MatrixXd apply(const MatrixXd& x) const {
    return cholesky_.solve(weighed(x));
  }

 private:
  const SparseMatrix& masses_;
  SparseCholesky cholesky_;
  bool exists_;
};

/// An M-orthonormal basis of what the block adds to the basis; directions that are
/// `smallest` or less are none. Twice, since once leaves what rounding made.
MatrixXd added(MatrixXd block, const MatrixXd& basis, const ShiftedInverse& inverse,
               double smallest) {
  for (int pass = 0; pass < 2 && block.cols() > 0; ++pass) {
    block -= basis * (basis.transpose() * inverse.weighed(block));
    const Eigen::SelfAdjointEigenSolver<MatrixXd> gram(block.transpose() *
                                                       inverse.weighed(block));
    const Index kept =
        (gram.eigenvalues().array() > smallest * smallest).count();  // the last ones
    const VectorXd lengths = gram.eigenvalues().tail(kept).cwiseSqrt();
    block =
        block * gram.eigenvectors().rightCols(kept) * lengths.cwiseInverse().asDiagonal();
  }
  return block;
}

MatrixXd start(Index rows) {
  std::mt19937_64 random(1);  // any block that is orthogonal to no mode
  MatrixXd block(rows, block_size);
  for (double& entry : block.reshaped())
    entry = static_cast<double>(random() >> 11U) * 0x1p-52 - 1;
  return block;
}

double largest_ratio(const SparseMatrix& stiffness, const SparseMatrix& masses) {
  const VectorXd k = stiffness.diagonal(), m = masses.diagonal();
  double largest = 0;
  for (Index i = 0; i < k.size(); ++i)
    if (m[i] > 0) largest = std::max(largest, k[i] / m[i]);
  return largest;
}

}  // namespace

std::optional<NaturalModes> natural_modes(const SparseMatrix& stiffness,
                                          const SparseMatrix& masses, int count) {
  constexpr double tolerance = 1e-9;  // of residuals; eigenvalues are better by a square
  constexpr double negligible = 1e-12;  // of a block: rounding
  const double largest = largest_ratio(stiffness, masses);
  const double shift = shift_of_largest * largest, zero = zero_of_largest * largest;
  const ShiftedInverse inverse(stiffness, masses, shift);
  if (!inverse.exists()) return std::nullopt;

  // Motions of massless unknowns are no modes: the inverse has none of them.
  MatrixXd block = inverse.apply(start(stiffness.rows()));
  block = added(block, MatrixXd(block.rows(), 0), inverse, negligible * block.norm());
  // No more directions than these have mass: what is found beyond them is rounding.
  const VectorXd own_masses = masses.diagonal();
  const Index with_mass = (own_masses.array() > 0).count();
  block = block.rightCols(std::min(block.cols(), with_mass)).eval();
  MatrixXd basis(block.rows(), 0);  // M-orthonormal
  MatrixXd projected;               // basis^T M (K + s M)^-1 M basis
  for (;;) {
    const Index size = basis.cols() + block.cols();
    basis.conservativeResize(Eigen::NoChange, size);
    basis.rightCols(block.cols()) = block;
    const MatrixXd image = inverse.apply(block), weighed = inverse.weighed(image);
    const MatrixXd columns = basis.transpose() * weighed;
    projected.conservativeResize(size, size);
    projected.rightCols(block.cols()) = columns;
    projected.bottomRows(block.cols()) = columns.transpose();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> ritz(projected);
    // Ascending inverses: the lowest modes are the last.
    const MatrixXd vectors = ritz.eigenvectors().rowwise().reverse();
    const VectorXd values = ritz.eigenvalues().reverse();
    const VectorXd squares = values.cwiseInverse().array() - shift;
    const Index zeros = (squares.array().abs() <= zero).count();
    const Index found = std::min<Index>(count, size - zeros);

    MatrixXd next = added(image, basis, inverse, negligible * values[0]);
    next = next.rightCols(std::min(next.cols(), with_mass - size)).eval();
    const MatrixXd residuals = next.transpose() * weighed *
                               vectors.bottomRows(block.cols()).leftCols(zeros + found);
    const bool has_converged =
        found == count && (residuals.colwise().norm().transpose().array() <=
                           tolerance * values.head(zeros + found).array())
                              .all();
    if (!has_converged && next.cols() > 0) {
      block = next;
      continue;
    }
    if (squares[0] < -zero) return std::nullopt;
    return NaturalModes{
        .zero_modes = static_cast<int>(zeros),
        .frequencies = squares.segment(zeros, found).cwiseSqrt() / (2 * std::numbers::pi),
        .shapes = basis * vectors.middleCols(zeros, found)};
  }
}

}  // namespace springcheck
