#include "statics/systems/direct_solver.hpp"

#include "meshing/basics/breakdown.hpp"
#include "meshing/basics/random_vector.hpp"

namespace springcheck::statics {
namespace {

constexpr int inverse_iterations = 12;

}  // namespace

int factor_shifted(SparseCholesky& cholesky, Eigen::SparseMatrix<double> matrix) {
  const double scale = matrix.diagonal().cwiseAbs().maxCoeff();
  double shift = 0;
  int tries = 1;
  for (; !cholesky.factor(matrix); ++tries) {
    const double next = shift == 0 ? 1e-8 * scale : 4 * shift;
    if (!(next > shift && next < 1e8 * scale))
      throw Breakdown("a tangent that no shift makes positive definite");
    matrix.diagonal().array() += next - shift;
    shift = next;
  }
  return tries;
}

DirectSolver::DirectSolver(const BlockMatrix& matrix, const Unknowns& unknowns)
    : matrix_(matrix), unknowns_(unknowns), triangle_(matrix, unknowns) {}

void DirectSolver::prepare() {
  definite_ = true;
  if (unknowns_.count() == 0) return;
  definite_ = cholesky_.factor(triangle_.copy_of(matrix_));
  ++factorisations_;
}

void DirectSolver::prepare_semidefinite() {
  definite_ = true;
  if (unknowns_.count() == 0) return;
  factorisations_ += factor_shifted(cholesky_, triangle_.copy_of(matrix_));
}

std::optional<Eigen::VectorXd> DirectSolver::solve(const Eigen::VectorXd& right) {
  if (!definite_) return std::nullopt;
  if (unknowns_.count() == 0) return right;
  return cholesky_.solve(right);
}

Eigen::VectorXd DirectSolver::negative_curvature(std::mt19937_64& random) {
  prepare_semidefinite();
  Eigen::VectorXd v = random_vector(unknowns_.count(), random);
  for (int i = 0; i < inverse_iterations; ++i) v = cholesky_.solve(v).normalized();
  return v;
}

}  // namespace springcheck::statics
