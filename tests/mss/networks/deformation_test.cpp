#include "mss/networks/deformation.hpp"

#include <Eigen/Dense>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "meshing/cell_geometry.hpp"
#include "tests/mss/blocks.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(deformation_test)

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

// tr E and its slopes written out; det F - 1 and its own, as above.
BOOST_AUTO_TEST_CASE(volume_change_of_squared_lengths_is_the_trace_of_green_s_strain) {
  using enum StrainMeasure;
  const Matrix3 H = random_gradient(3, 0.5), F = Matrix3::Identity() + H;
  BOOST_TEST(volume_change(green, H) == ((F.transpose() * F).trace() - 3) / 2,
             boost::test_tools::tolerance(1e-13));
  BOOST_TEST((volume_gradient(green, H) - F).norm() == 0);
  BOOST_TEST((volume_hessian(green, H) - Matrix9::Identity()).norm() == 0);
  for (const StrainMeasure measure : {engineering, logarithmic, hencky}) {
    BOOST_TEST(volume_change(measure, H) == volume_change(H));
    BOOST_TEST((volume_gradient(measure, H) - cofactor(H)).norm() == 0);
    BOOST_TEST((volume_hessian(measure, H) - volume_hessian(H)).norm() == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
