#include "mss/networks/deformation.hpp"

#include <Eigen/Dense>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "meshing/cell_geometry.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(deformation_test)

namespace {

Matrix3 random_gradient(unsigned seed, double size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> entry(-size, size);
  Matrix3 H;
  for (double& value : H.reshaped()) value = entry(random);
  return H;
}

constexpr VirtualSprings law{.shear_modulus = 0.7, .volume_modulus = 1.3};

/// The axes of an icosahedron by another way: its vertices at latitude atan(1/2).
double energy_by_hand(const Matrix3& F) {
  double sum = std::pow(F.col(2).norm() - 1, 2);
  for (int i = 0; i < 5; ++i) {
    const double longitude = 2 * std::numbers::pi * i / 5;
    const Vector3 n(2 * std::cos(longitude), 2 * std::sin(longitude), 1);
    sum += std::pow((F * n).norm() / std::sqrt(5.) - 1, 2);
  }
  return 5 * law.shear_modulus / 4 * sum +
         law.volume_modulus / 2 * std::pow(F.determinant() - 1, 2);
}

}  // namespace

BOOST_AUTO_TEST_CASE(volume_change_is_the_determinant_less_one,
                     *boost::unit_test::tolerance(1e-13)) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Matrix3 H = random_gradient(seed, 1);
    BOOST_TEST(1 + volume_change(H) == (Matrix3::Identity() + H).determinant());
  }
}

// 1e-9 (1 + 2 + 3) and 1e-18 (2 + 6 + 3): the determinant itself would leave 7 digits.
BOOST_AUTO_TEST_CASE(tiny_volume_change_keeps_its_digits,
                     *boost::unit_test::tolerance(1e-15)) {
  const Matrix3 H = 1e-9 * Vector3(1, 2, 3).asDiagonal().toDenseMatrix();
  BOOST_TEST(volume_change(H) == 6e-9 + 11e-18);
}

// The determinant is linear in every entry: no truncation, round-off alone.
BOOST_AUTO_TEST_CASE(cofactor_and_hessian_are_slopes_of_the_volume) {
  constexpr double step = 0.25;
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Matrix3 H = random_gradient(seed, 1), area = cofactor(H);
    const Matrix9 hessian = volume_hessian(H);
    for (Eigen::Index entry = 0; entry < 9; ++entry) {
      Matrix3 ahead = H, behind = H;
      ahead.reshaped()[entry] += step;
      behind.reshaped()[entry] -= step;
      BOOST_TEST(std::abs(area.reshaped()[entry] -
                          (volume_change(ahead) - volume_change(behind)) / (2 * step)) <
                 1e-14);
      const Matrix3 slope = (cofactor(ahead) - cofactor(behind)) / (2 * step);
      BOOST_TEST((hessian.col(entry) - slope.reshaped()).norm() < 1e-14);
    }
  }
}

// Golec 2018, Eq. 5.19 to 5.21 with the signs put right: the volume of a box's mean edges
// changes by (sx Y x Z + sy Z x X + sz X x Y)/4 per corner; here by way of F. Round-off.
BOOST_AUTO_TEST_CASE(volume_of_the_mean_edges_is_that_of_the_mean_deformation) {
  const Vector3 size(2, 1, 0.5);
  Eigen::Matrix<double, 3, 8> signs;
  signs << -1, 1, 1, -1, -1, 1, 1, -1,  //
      -1, -1, 1, 1, -1, -1, 1, 1,       //
      -1, -1, -1, -1, 1, 1, 1, 1;
  const CornerPositions X = size.asDiagonal() * signs / 2;
  const CornerPositions G = cell_volume_gradient(X) / cell_volume(X);
  std::srand(2);  // Eigen's Random draws from rand()
  const CornerPositions x = X + 0.3 * Eigen::Matrix<double, 3, 8>::Random();
  const Matrix3 edges = x * signs.transpose() / 4, F = x * G.transpose();
  BOOST_TEST((F * size.asDiagonal().toDenseMatrix() - edges).norm() < 1e-14);
  Matrix3 areas;
  areas << edges.col(1).cross(edges.col(2)), edges.col(2).cross(edges.col(0)),
      edges.col(0).cross(edges.col(1));
  const Matrix3 H = F - Matrix3::Identity();
  BOOST_TEST((size.prod() * cofactor(H) * G - areas * signs / 4).norm() < 1e-14);
}

// Rotated at random, as its axes need not be ours.
BOOST_AUTO_TEST_CASE(energy_is_that_of_an_icosahedron_s_axes) {
  // Our axes to those of energy_by_hand: one on the pole, and one of its neighbours on
  // the meridian of longitude 0.
  const double phi = std::numbers::phi;
  const Vector3 pole = Vector3(phi, 1, 0).normalized(),
                near = Vector3(phi, -1, 0).normalized();
  Matrix3 frame;
  frame.col(2) = pole;
  frame.col(0) = (near - near.dot(pole) * pole).normalized();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Matrix3 H = random_gradient(seed, 0.5);
    BOOST_TEST(law.energy(H) == energy_by_hand((Matrix3::Identity() + H) * frame),
               boost::test_tools::tolerance(1e-13));
  }
}

// Exact on paper: round-off.
BOOST_AUTO_TEST_CASE(tangent_at_rest_is_that_of_hooke) {
  const Matrix9 A = law.tangent(Matrix3::Zero());
  const double mu = law.shear_modulus, lambda = mu + law.volume_modulus;
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Matrix3 H = random_gradient(seed, 1), strain = (H + H.transpose()) / 2;
    const Matrix3 hooke = lambda * strain.trace() * Matrix3::Identity() + 2 * mu * strain;
    BOOST_TEST((A * H.reshaped() - hooke.reshaped()).norm() < 1e-14);
  }
}

// Central differences with a step of 1e-5: truncation of the order of its square, round-
// off 1e-16/1e-5.
BOOST_AUTO_TEST_CASE(stress_and_tangent_are_slopes) {
  constexpr double step = 1e-5;
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Matrix3 H = random_gradient(seed, 0.7), P = law.stress(H);
    const Matrix9 A = law.tangent(H);
    for (Eigen::Index entry = 0; entry < 9; ++entry) {
      Matrix3 ahead = H, behind = H;
      ahead.reshaped()[entry] += step;
      behind.reshaped()[entry] -= step;
      BOOST_TEST(std::abs(P.reshaped()[entry] -
                          (law.energy(ahead) - law.energy(behind)) / (2 * step)) < 1e-8);
      const Matrix3 slope = (law.stress(ahead) - law.stress(behind)) / (2 * step);
      BOOST_TEST((A.col(entry) - slope.reshaped()).norm() < 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(direction_pressed_to_a_point_pulls_nowhere) {
  const Matrix3 H = -Matrix3::Identity();
  BOOST_TEST(law.stress(H).norm() == 0);
  BOOST_TEST(law.tangent(H).allFinite());
}

BOOST_AUTO_TEST_SUITE_END()
