#include "statics/systems/natural_modes.hpp"

#include <Spectra/SymGEigsShiftSolver.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "statics/systems/sparse_cholesky.hpp"

namespace springcheck {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

constexpr double shift = 1e-6, zero = 1e-9;  // of the largest K_ii/M_ii

/// x -> M x, as Spectra asks for it.
class Masses {
 public:
  using Scalar = double;
  explicit Masses(const SparseMatrix& masses) : masses_(masses) {}

  [[nodiscard]] Index rows() const { return masses_.rows(); }
  [[nodiscard]] Index cols() const { return masses_.cols(); }
  [[nodiscard]] VectorXd times(const VectorXd& x) const {
    return masses_.selfadjointView<Eigen::Lower>() * x;
  }
  void perform_op(const double* x, double* y) const {
    VectorXd::Map(y, rows()) = times(VectorXd::Map(x, rows()));
  }

 private:
  const SparseMatrix& masses_;
};

/// x -> (K + s M)^-1 x, as Spectra asks for it.
class ShiftedInverse {
 public:
  using Scalar = double;
  explicit ShiftedInverse(const SparseMatrix& shifted)
      : size_(shifted.rows()), exists_(cholesky_.factor(shifted)) {}

  [[nodiscard]] bool exists() const { return exists_; }
  [[nodiscard]] Index rows() const { return size_; }
  [[nodiscard]] Index cols() const { return size_; }
  void set_shift(double) {}  // the matrix has it
  [[nodiscard]] VectorXd times(const VectorXd& x) const { return cholesky_.solve(x); }
  void perform_op(const double* x, double* y) const {
    VectorXd::Map(y, size_) = times(VectorXd::Map(x, size_));
  }

 private:
  Index size_;
  SparseCholesky cholesky_;
  bool exists_;
};

struct Pairs {
  VectorXd squares;  // omega^2 over the largest K_ii/M_ii, ascending
  MatrixXd shapes;   // M-orthonormal
};

/// The `wanted` lowest pairs of a small problem, whose matrices are full: those of M x =
/// mu (K + s M) x with the largest mu = 1/(omega^2 + s).
Pairs lowest_of_full(const SparseMatrix& shifted, const SparseMatrix& masses,
                     Index wanted) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver{MatrixXd(masses),
                                                                  MatrixXd(shifted)};
  const VectorXd inverses = solver.eigenvalues().tail(wanted).reverse();
  const MatrixXd shapes = solver.eigenvectors().rightCols(wanted).rowwise().reverse();
  return {inverses.cwiseInverse().array() - shift,
          shapes * inverses.cwiseSqrt().cwiseInverse().asDiagonal()};
}

Pairs lowest_of_sparse(const SparseMatrix& masses, ShiftedInverse& inverse,
                       Index wanted) {
  Masses weigh(masses);
  Spectra::SymGEigsShiftSolver<ShiftedInverse, Masses, Spectra::GEigsMode::ShiftInvert>
      solver(inverse, weigh, wanted, std::min(2 * wanted + 20, inverse.rows()), -shift);
  solver.init();
  constexpr Index restarts = 1000;
  constexpr double tolerance = 1e-10;  // of residuals; eigenvalues are better by a square
  solver.compute(Spectra::SortRule::LargestMagn, restarts, tolerance,
                 Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw std::runtime_error("natural modes: no convergence");
  Pairs pairs{solver.eigenvalues(), solver.eigenvectors()};
  // Unknowns without mass keep what the start gave them; the inverse makes them follow.
  for (Index j = 0; j < wanted; ++j)
    pairs.shapes.col(j) =
        (pairs.squares[j] + shift) * inverse.times(weigh.times(pairs.shapes.col(j)));
  return pairs;
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
  // Spectra's tolerances are absolute: the largest omega^2 are made about 1.
  const double largest = largest_ratio(stiffness, masses);
  const SparseMatrix shifted = stiffness / largest + shift * masses;
  ShiftedInverse inverse(shifted);
  if (!inverse.exists()) return std::nullopt;
  const Index with_mass = (VectorXd(masses.diagonal()).array() > 0).count();

  constexpr Index zeros_of_a_free_body = 6;
  Index wanted = std::min(count + zeros_of_a_free_body, with_mass);
  for (;; wanted = std::min(2 * wanted, with_mass)) {
    const bool is_small = shifted.rows() <= 100 || wanted == shifted.rows();
    const Pairs pairs = is_small ? lowest_of_full(shifted, masses, wanted)
                                 : lowest_of_sparse(masses, inverse, wanted);
    if (pairs.squares[0] < -zero) return std::nullopt;
    const Index zeros = (pairs.squares.array().abs() <= zero).count();
    const Index found = std::min<Index>(count, wanted - zeros);
    if (found < count && wanted < with_mass) continue;
    return NaturalModes{
        .zero_modes = static_cast<int>(zeros),
        .frequencies = (largest * pairs.squares.segment(zeros, found)).cwiseSqrt() /
                       (2 * std::numbers::pi),
        .shapes = pairs.shapes.middleCols(zeros, found)};
  }
}

}  // namespace springcheck
