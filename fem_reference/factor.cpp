#include "fem_reference/factor.hpp"

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCholesky>

namespace springcheck::fem_reference {

struct SymmetricFactor::Solvers {
  Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower> definite;
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> indefinite;
  bool definite_analysed = false;
  bool indefinite_analysed = false;
  bool last_definite = true;
};

SymmetricFactor::SymmetricFactor() : solvers_(std::make_unique<Solvers>()) {
  solvers_->definite.cholmod().print = 0;         // a failure is an answer, not a warning
}

SymmetricFactor::~SymmetricFactor() = default;

bool SymmetricFactor::factor_definite(const SparseMatrix& lower) {
  auto& cholesky = solvers_->definite;
  if (!solvers_->definite_analysed) cholesky.analyzePattern(lower);
  solvers_->definite_analysed = true;
  solvers_->last_definite = true;
  cholesky.factorize(lower);
  return cholesky.info() == Eigen::Success;
}

bool SymmetricFactor::factor_indefinite(const SparseMatrix& lower) {
  auto& ldlt = solvers_->indefinite;
  if (!solvers_->indefinite_analysed) ldlt.analyzePattern(lower);
  solvers_->indefinite_analysed = true;
  solvers_->last_definite = false;
  ldlt.factorize(lower);
  return ldlt.info() == Eigen::Success;
}

int SymmetricFactor::negative_pivots() const {
  return static_cast<int>((solvers_->indefinite.vectorD().array() < 0).count());
}

Eigen::VectorXd SymmetricFactor::solve(const Eigen::VectorXd& right) const {
  if (solvers_->last_definite) return solvers_->definite.solve(right);
  return solvers_->indefinite.solve(right);
}

}  // namespace springcheck::fem_reference
