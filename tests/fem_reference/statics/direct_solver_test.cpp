#include "fem_reference/statics/direct_solver.hpp"

#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>
#include <random>

using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(direct_solver_test)

namespace {

/// Chain of springs k_i between fixed ends, symmetric and tridiagonal.
SparseMatrix chain(const std::vector<double>& k) {
  const auto n = static_cast<int>(k.size()) - 1;
  SparseMatrix matrix(n, n);
  for (int i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    matrix.insert(i, i) = k[at] + k[at + 1];
    if (i > 0) matrix.insert(i, i - 1) = -k[at];
    if (i < n - 1) matrix.insert(i, i + 1) = -k[at + 1];
  }
  matrix.makeCompressed();
  return matrix;
}

const std::vector<double> stable{1, 2, 3, 2.5, 1.5, 2, 3, 1};
const std::vector<double> unstable{1, 2, -3, 2.5, 1.5, -2, 3, 1};

int negative_eigenvalues(const SparseMatrix& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen{Eigen::MatrixXd(matrix)};
  return static_cast<int>((eigen.eigenvalues().array() < 0).count());
}

double residual(const DirectSolver& solver, const SparseMatrix& matrix) {
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(matrix.rows(), -1, 2);
  return (matrix * solver.solve(right) - right).norm() / right.norm();
}

}  // namespace

// Round-off.
BOOST_AUTO_TEST_CASE(definite_matrices_are_solved_by_either_factor) {
  DirectSolver solver;
  BOOST_TEST(solver.factor_definite(chain(stable)));
  BOOST_TEST(residual(solver, chain(stable)) < 1e-14);
  BOOST_TEST(solver.factor_indefinite(chain(stable)));
  BOOST_TEST(residual(solver, chain(stable)) < 1e-14);
  BOOST_TEST(solver.negative_pivots() == 0);
}

BOOST_AUTO_TEST_CASE(indefinite_matrices_are_told_and_solved_and_counted) {
  const SparseMatrix matrix = chain(unstable);
  BOOST_TEST_REQUIRE(negative_eigenvalues(matrix) == 2);
  DirectSolver solver;
  BOOST_TEST(!solver.factor_definite(matrix));
  BOOST_TEST(solver.factor_indefinite(matrix));
  BOOST_TEST(solver.negative_pivots() == 2);
  BOOST_TEST(residual(solver, matrix) < 1e-13);
}

// The last factor made is the one that solves, whatever came before.
BOOST_AUTO_TEST_CASE(factors_of_one_pattern_follow_each_other) {
  DirectSolver solver;
  BOOST_TEST(solver.factor_indefinite(chain(unstable)));
  BOOST_TEST(solver.factor_definite(chain(stable)));
  BOOST_TEST(residual(solver, chain(stable)) < 1e-14);
  BOOST_TEST(!solver.factor_definite(chain(unstable)));
  BOOST_TEST(solver.factor_indefinite(chain(unstable)));
  BOOST_TEST(residual(solver, chain(unstable)) < 1e-13);
  BOOST_TEST(solver.factor_definite(2 * chain(stable)));
  BOOST_TEST(residual(solver, 2 * chain(stable)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(singular_matrices_have_no_factor) {
  SparseMatrix zero = chain(stable);
  zero *= 0;
  DirectSolver solver;
  BOOST_TEST(!solver.factor_definite(zero));
  BOOST_TEST(!solver.factor_indefinite(zero));
}

BOOST_AUTO_TEST_SUITE_END()
