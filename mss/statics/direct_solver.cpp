#include "mss/statics/direct_solver.hpp"

#include "meshing/breakdown.hpp"
#include "meshing/random_vector.hpp"

namespace springcheck::mss {
namespace {

constexpr int inverse_iterations = 12;

}  // namespace

DirectSolver::DirectSolver(const Network& network, const std::vector<bool>& is_free)
    : assembly_(network, is_free) {}

void DirectSolver::prepare(const Tangent& tangent) {
  factor(assembly_.assemble(tangent));
}

void DirectSolver::prepare_clamped(const Tangent& tangent) {
  factor_shifted(assembly_.assemble(tangent));
}

std::optional<Eigen::VectorXd> DirectSolver::solve(const Eigen::VectorXd& right) {
  if (!definite_) return std::nullopt;
  if (assembly_.size() == 0) return right;
  return cholesky_.solve(right);
}

Eigen::VectorXd DirectSolver::negative_curvature(const Tangent& tangent,
                                                 std::mt19937_64& random) {
  factor_shifted(assembly_.assemble(tangent));
  Eigen::VectorXd v = random_vector(assembly_.size(), random);
  for (int i = 0; i < inverse_iterations; ++i) v = cholesky_.solve(v).normalized();
  return v;
}

void DirectSolver::factor(const Eigen::SparseMatrix<double>& matrix) {
  definite_ = true;
  if (assembly_.size() == 0) return;
  definite_ = cholesky_.factor(matrix);
  ++factorisations_;
}

/// Factors the matrix plus the smallest of a series of multiples of the identity that
/// makes it positive definite.
void DirectSolver::factor_shifted(Eigen::SparseMatrix<double> matrix) {
  const double scale = matrix.diagonal().cwiseAbs().maxCoeff();
  double shift = 0;
  for (factor(matrix); !definite_; factor(matrix)) {
    const double next = shift == 0 ? 1e-8 * scale : 4 * shift;
    if (!(next > shift && next < 1e8 * scale))
      throw Breakdown("a tangent that no shift makes positive definite");
    matrix.diagonal().array() += next - shift;
    shift = next;
  }
}

}  // namespace springcheck::mss
