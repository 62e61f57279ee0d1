#include "fem_reference/statics/direct_solver.hpp"

#include <Eigen/SparseCholesky>

#include "meshing/sparse_cholesky.hpp"

namespace springcheck::fem_reference {

struct DirectSolver::Solvers {
  SparseCholesky definite;
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> indefinite;
  bool indefinite_analysed = false;
  bool last_definite = true;
  int factorisations = 0;
};

DirectSolver::DirectSolver() : solvers_(std::make_unique<Solvers>()) {}

DirectSolver::~DirectSolver() = default;

bool DirectSolver::factor_definite(const SparseMatrix& matrix) {
  solvers_->last_definite = true;
  ++solvers_->factorisations;
  return solvers_->definite.factor(matrix);
}

bool DirectSolver::factor_indefinite(const SparseMatrix& matrix) {
  auto& ldlt = solvers_->indefinite;
  if (!solvers_->indefinite_analysed) ldlt.analyzePattern(matrix);
  solvers_->indefinite_analysed = true;
  solvers_->last_definite = false;
  ldlt.factorize(matrix);
  ++solvers_->factorisations;
  return ldlt.info() == Eigen::Success;
}

int DirectSolver::negative_pivots() const {
  return static_cast<int>((solvers_->indefinite.vectorD().array() < 0).count());
}

int DirectSolver::factorisations() const {
  return solvers_->factorisations;
}

Eigen::VectorXd DirectSolver::solve(const Eigen::VectorXd& right) const {
  if (solvers_->last_definite) return solvers_->definite.solve(right);
  return solvers_->indefinite.solve(right);
}

}  // namespace springcheck::fem_reference
