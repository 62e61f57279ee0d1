#include "tissue/non_negative_least_squares.hpp"

#include <Eigen/QR>
#include <boost/test/unit_test.hpp>
#include <random>

using namespace springcheck::tissue;

BOOST_AUTO_TEST_SUITE(non_negative_least_squares_test)

namespace {

std::mt19937_64 engine{7};

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns) {
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(engine); });
}

}  // namespace

// Kuhn and Tucker's conditions, which only the solution meets: x >= 0, the gradient
// A^T (A x - b) is 0 where x is positive and not negative elsewhere. Round-off.
BOOST_AUTO_TEST_CASE(no_other_vector_is_better) {
  int positive = 0, zero = 0;
  for (int i = 0; i < 200; ++i) {
    const Eigen::MatrixXd A = random_matrix(30, 12);
    const Eigen::VectorXd b = random_matrix(30, 1);
    const Eigen::VectorXd x = non_negative_least_squares(A, b);
    const Eigen::VectorXd gradient = A.transpose() * (A * x - b);
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      BOOST_TEST(x[j] >= 0);
      BOOST_TEST(gradient[j] > -1e-11);
      if (x[j] > 0) BOOST_TEST(gradient[j] < 1e-11);
      ++(x[j] > 0 ? positive : zero);
    }
  }
  BOOST_TEST(positive > 600);
  BOOST_TEST(zero > 600);
}

// Columns as alike as decays of neighbouring times.
BOOST_AUTO_TEST_CASE(columns_may_be_alike) {
  Eigen::MatrixXd A(60, 14);
  for (Eigen::Index i = 0; i < A.rows(); ++i)
    for (Eigen::Index j = 0; j < A.cols(); ++j)
      A(i, j) = std::exp(-std::pow(10., 0.1 * static_cast<double>(i) - 3) /
                         std::pow(3., static_cast<double>(j) - 7));
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(14);
  wanted[3] = 2;
  wanted[8] = 0.5;
  const Eigen::VectorXd b = A * wanted;
  const Eigen::VectorXd x = non_negative_least_squares(A, b);
  BOOST_TEST(x.minCoeff() >= 0);
  BOOST_TEST((A * x - b).norm() < 1e-9 * b.norm());
}

BOOST_AUTO_TEST_CASE(a_positive_solution_is_that_of_least_squares) {
  const Eigen::MatrixXd A = random_matrix(20, 5);
  const Eigen::VectorXd wanted{{1, 2, 3, 4, 5}};
  const Eigen::VectorXd b = A * wanted;
  BOOST_TEST((non_negative_least_squares(A, b) - wanted).norm() < 1e-12);
  BOOST_TEST(non_negative_least_squares(-A.cwiseAbs(), b.cwiseAbs()).norm() == 0);
}

BOOST_AUTO_TEST_SUITE_END()
