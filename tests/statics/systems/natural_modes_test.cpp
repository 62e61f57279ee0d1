#include <boost/test/unit_test.hpp>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <vector>

#include "statics/systems/natural_modes.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(natural_modes_test)

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// The stiffness of masses m [kg] in a row, with springs k [N/m] between neighbours, free
/// at both ends.
SparseMatrix chain(int masses, double k) {
  SparseMatrix K(masses, masses);
  for (int i = 0; i + 1 < masses; ++i) {
    K.coeffRef(i, i) += k;
    K.coeffRef(i + 1, i + 1) += k;
    K.coeffRef(i + 1, i) -= k;
  }
  return K;
}

SparseMatrix diagonal(const Eigen::VectorXd& entries) {
  return SparseMatrix(entries.asDiagonal());
}

double square(double frequency) {
  return std::pow(2 * std::numbers::pi * frequency, 2);
}

}  // namespace

// On paper omega^2 = k (1/m1 + 1/m2), where the masses move against each other, x as 1/m.
// The tolerance is round-off and six digits more: the shift is 1e-6 of the largest
// eigenvalue.
BOOST_AUTO_TEST_CASE(two_masses_swing_against_each_other,
                     *boost::unit_test::tolerance(1e-9)) {
  const double k = 3, m1 = 2, m2 = 5;  // N/m, kg
  const auto modes =
      natural_modes(chain(2, k), diagonal(Eigen::Vector2d(m1, m2)), 10).value();
  BOOST_TEST(modes.zero_modes == 1);
  BOOST_TEST_REQUIRE(modes.frequencies.size() == 1);
  BOOST_TEST(square(modes.frequencies[0]) == k * (1 / m1 + 1 / m2));
  const auto x = modes.shapes.col(0);
  BOOST_TEST(x[0] * m1 == -x[1] * m2);
  BOOST_TEST(m1 * x[0] * x[0] + m2 * x[1] * x[1] == 1.);
}

// This holds however rounding goes, with springs that differ by eight digits.
BOOST_AUTO_TEST_CASE(there_are_no_more_modes_than_masses) {
  for (int n = 2; n <= 40; ++n) {
    SparseMatrix stiffness(n, n);
    Eigen::VectorXd masses(n);
    for (int i = 0; i < n; ++i) {
      stiffness.coeffRef(i, i) =
          std::pow(10, 8. * i / n - 4) + 3 * std::pow(10, 8. * (i + 1) / n - 4);
      if (i > 0) stiffness.coeffRef(i, i - 1) = -std::pow(10, 8. * i / n - 4);
      masses[i] = 1 + std::sin(i);
    }
    const auto modes = natural_modes(stiffness, diagonal(masses), 50).value();
    BOOST_TEST(modes.zero_modes + modes.frequencies.size() == n);
  }
}

// On paper omega_j = 2 sqrt(k/m) sin(pi j/(2 n)).
BOOST_AUTO_TEST_CASE(a_chain_s_lowest_modes_come_in_order,
                     *boost::unit_test::tolerance(1e-9)) {
  constexpr int n = 500;
  const double k = 7, m = 0.3;
  const auto modes =
      natural_modes(chain(n, k), diagonal(Eigen::VectorXd::Constant(n, m)), 10).value();
  BOOST_TEST(modes.zero_modes == 1);
  BOOST_TEST_REQUIRE(modes.frequencies.size() == 10);
  for (int j = 1; j <= 10; ++j)
    BOOST_TEST(std::sqrt(square(modes.frequencies[j - 1])) ==
                   2 * std::sqrt(k / m) * std::sin(std::numbers::pi * j / (2 * n)),
               boost::test_tools::tolerance(1e-7));
}

// Equal chains stand side by side, so that every value comes as often, and there are as
// many zeros. Stiff ones of small masses are no other problem.
void find_all_of_equal_chains(int chains, int n, int count, double k) {
  std::vector<Eigen::Triplet<double>> entries;
  const SparseMatrix one = chain(n, k);
  for (int c = 0; c < chains; ++c)
    for (int j = 0; j < n; ++j)
      for (SparseMatrix::InnerIterator at(one, j); at; ++at)
        entries.emplace_back(n * c + static_cast<int>(at.row()), n * c + j, at.value());
  SparseMatrix K(n * chains, n * chains);
  K.setFromTriplets(entries.begin(), entries.end());
  const auto masses = diagonal(Eigen::VectorXd::Ones(n * chains));
  const auto modes = natural_modes(K, masses, count * chains).value();
  BOOST_TEST(modes.zero_modes == chains);
  for (int j = 1; j <= count; ++j)
    for (int c = 0; c < chains; ++c)
      BOOST_TEST(square(modes.frequencies[chains * (j - 1) + c]) ==
                     4 * k * std::pow(std::sin(std::numbers::pi * j / (2 * n)), 2),
                 boost::test_tools::tolerance(1e-8));
  const Eigen::MatrixXd gram = modes.shapes.transpose() * modes.shapes;
  BOOST_TEST((gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols())).norm() < 1e-10);
  const auto again = natural_modes(K, masses, count * chains).value();
  BOOST_TEST(bool(again.shapes == modes.shapes));  // the same bits
}

BOOST_AUTO_TEST_CASE(equal_modes_are_all_found) {
  find_all_of_equal_chains(14, 60, 3, 1);
  find_all_of_equal_chains(6, 40, 3, 1);
  for (const double k : {1e-18, 1., 1e18}) {
    find_all_of_equal_chains(2, 300, 5, k);
    find_all_of_equal_chains(3, 200, 2, k);
  }
}

// The modes are compared with those of Eigen's dense solver: a mass matrix is not
// diagonal, and an unknown is without mass and out of reach of the others' springs.
BOOST_AUTO_TEST_CASE(masses_need_be_neither_diagonal_nor_definite) {
  constexpr int n = 60;
  SparseMatrix K = chain(n, 2), M(n, n);
  for (int i = 0; i + 1 < n; ++i) {
    M.coeffRef(i, i) += 2. / 6;
    M.coeffRef(i + 1, i + 1) += 2. / 6;
    M.coeffRef(i + 1, i) += 1. / 6;
  }
  const auto full = [](const SparseMatrix& lower) {
    return Eigen::MatrixXd(Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>());
  };
  const Eigen::VectorXd expected =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(full(K), full(M))
          .eigenvalues();
  K.conservativeResize(n + 1, n + 1);
  M.conservativeResize(n + 1, n + 1);
  K.coeffRef(n, n) = 1;
  const auto modes = natural_modes(K, M, 12).value();
  BOOST_TEST(modes.zero_modes == 1);
  for (int j = 0; j < 12; ++j)
    BOOST_TEST(square(modes.frequencies[j]) == expected[j + 1],
               boost::test_tools::tolerance(1e-8));
  BOOST_TEST(modes.shapes.row(n).norm() < 1e-10);
}

BOOST_AUTO_TEST_CASE(an_unstable_body_has_no_modes) {
  SparseMatrix K = chain(20, 1);
  K.coeffRef(0, 0) -= 1.5;
  const auto masses = diagonal(Eigen::VectorXd::Ones(20));
  BOOST_TEST(!natural_modes(K, masses, 3).has_value());
}

BOOST_AUTO_TEST_SUITE_END()
