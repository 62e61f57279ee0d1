#include "statics/systems/sparse_cholesky.hpp"

#include <omp.h>

#include <Eigen/CholmodSupport>
#include <new>
#include <stdexcept>
#include <string>

#include "meshing/basics/random_numbers.hpp"

namespace springcheck {
namespace {

/// Eigen reads no status of CHOLMOD: a factor for which there was no memory is a success
/// to it, and solutions with it are left unset. Negative ones are errors.
void check(const cholmod_common& common) {
  if (common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  if (common.status == CHOLMOD_TOO_LARGE)
    throw std::length_error("a matrix whose factor is too large for CHOLMOD");
  if (common.status < CHOLMOD_OK)
    throw std::runtime_error("CHOLMOD ends with status " + std::to_string(common.status));
}

/// CHOLMOD starts teams of four, whatever OMP_NUM_THREADS says, for loops so small that
/// factors of 10^3 cells take three times as long. A thread without levels has no teams.
void stay_on_this_thread() {
  omp_set_max_active_levels(0);
}

}  // namespace

struct SparseCholesky::Factor {
  Eigen::CholmodSupernodalLLT<Matrix, Eigen::Lower> cholmod;
  bool analysed = false;
};

SparseCholesky::SparseCholesky() : factor_(std::make_unique<Factor>()) {
  factor_->cholmod.cholmod().print = 0;  // a failure is an answer, not a warning
}

SparseCholesky::~SparseCholesky() = default;

bool SparseCholesky::factor(const Matrix& matrix) {
  auto& cholmod = factor_->cholmod;
  stay_on_this_thread();
  if (!factor_->analysed) {
    const std::lock_guard lock(random_numbers());  // the ordering is METIS's
    cholmod.analyzePattern(matrix);
    check(cholmod.cholmod());
  }
  factor_->analysed = true;
  cholmod.factorize(matrix);
  check(cholmod.cholmod());
  return cholmod.info() == Eigen::Success;
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& right) const {
  stay_on_this_thread();
  Eigen::MatrixXd solution = factor_->cholmod.solve(right);
  check(factor_->cholmod.cholmod());
  return solution;
}

Eigen::VectorXd SparseCholesky::solve(const Eigen::VectorXd& right) const {
  stay_on_this_thread();
  Eigen::VectorXd solution = factor_->cholmod.solve(right);
  check(factor_->cholmod.cholmod());
  return solution;
}

}  // namespace springcheck
