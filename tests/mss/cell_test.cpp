#define BOOST_TEST_MODULE cell
#include "mss/cell.hpp"

#include <boost/test/unit_test.hpp>
#include <random>
#include <set>

using namespace springcheck;
using namespace springcheck::mss;

namespace {

CornerPositions unit_cube() {
  CornerPositions x(3, 8);
  x << 0, 1, 1, 0, 0, 1, 1, 0,  //
      0, 0, 1, 1, 0, 0, 1, 1,   //
      0, 0, 0, 0, 1, 1, 1, 1;
  return x;
}

CornerPositions distorted_cube(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> moved(-0.3, 0.3);
  CornerPositions x = unit_cube();
  for (double& coordinate : x.reshaped()) coordinate += moved(random);
  return x;
}

/// Derivative of f(corners) with respect to one coordinate, by a central difference.
template <class Function>
auto slope(const Function& f, CornerPositions x, Eigen::Index corner,
           Eigen::Index coordinate) {
  constexpr double step = 0.25;  // any step will do, see the tests
  x(coordinate, corner) += step;
  const auto ahead = f(x);
  x(coordinate, corner) -= 2 * step;
  return ((ahead - f(x)) / (2 * step));
}

constexpr std::array<Eigen::Index, 3> coordinates{0, 1, 2};

}  // namespace

// Lengths in the unit cube tell edges, face and inner diagonals apart.
BOOST_AUTO_TEST_CASE(cell_has_twelve_edges_twelve_face_and_four_inner_diagonals) {
  const CornerPositions x = unit_cube();
  std::set<std::set<std::size_t>> pairs;
  const auto check = [&](const auto& springs, double squared_length) {
    for (const auto& [i, j] : springs) {
      BOOST_TEST((x.col(static_cast<Eigen::Index>(j)) - x.col(static_cast<Eigen::Index>(i)))
                     .squaredNorm() == squared_length);
      pairs.insert({i, j});
    }
  };
  check(cell_edges, 1);
  check(cell_face_diagonals, 2);
  check(cell_inner_diagonals, 3);
  BOOST_TEST(pairs.size() == 28U);  // all of the 8 * 7/2 there are
}

// Exact on paper: round-off.
BOOST_AUTO_TEST_CASE(mean_edges_and_volume_are_exact_for_parallelepipeds,
                     *boost::unit_test::tolerance(1e-14)) {
  const Eigen::Matrix3d F =
      (Eigen::Matrix3d() << 2, 0.5, -0.3, 0.1, 1.5, 0.4, -0.2, 0.7, 0.9).finished();
  CornerPositions x = unit_cube();
  x = (F * x).colwise() + Vector3(3, -2, 5);
  BOOST_TEST((mean_edges(x) - F).norm() < 1e-14);
  BOOST_TEST(mean_edge_volume(x) == F.determinant());
}

// Away from parallelepipeds it is another volume: of a frustum, height times middle
// section (here 5 * 2 * 2), where the exact one is 5 (9 + 3 + 1)/3.
BOOST_AUTO_TEST_CASE(mean_edge_volume_of_a_frustum_is_height_times_middle_section,
                     *boost::unit_test::tolerance(1e-15)) {
  CornerPositions x = unit_cube();
  for (Eigen::Index i = 0; i < 8; ++i) {
    x.col(i).head<2>() *= i < 4 ? 3 : 1;
    x.col(i).z() *= 5;
  }
  BOOST_TEST(mean_edge_volume(x) == 20);
}

// The volume is linear in every single coordinate, so the central difference has no
// truncation error and the tolerance is round-off.
BOOST_AUTO_TEST_CASE(gradient_is_the_slope_of_the_volume) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const CornerPositions x = distorted_cube(seed);
    const auto gradient = mean_edge_volume_gradient(x);
    for (Eigen::Index i = 0; i < 8; ++i)
      for (const Eigen::Index r : coordinates)
        BOOST_TEST(std::abs(gradient(r, i) -
                            slope(mean_edge_volume, x, i, r)) < 1e-14);
  }
}

// Golec 2018, Eq. 5.21: the corners at the two ends of an inner diagonal are pushed
// oppositely. The printed signs of Eq. 5.20 do not do that. To the bit.
BOOST_AUTO_TEST_CASE(opposite_corners_have_opposite_gradients) {
  const auto gradient = mean_edge_volume_gradient(distorted_cube(3));
  for (const auto& [i, j] : cell_inner_diagonals)
    BOOST_TEST((gradient.col(static_cast<Eigen::Index>(i)) ==
                -gradient.col(static_cast<Eigen::Index>(j))));
}

// Eq. 5.20 with its signs put right, by hand for the unit cube, where the three products
// are the unit vectors: every corner is pushed outward.
BOOST_AUTO_TEST_CASE(gradient_of_a_cube_points_outward_at_every_corner) {
  const auto gradient = mean_edge_volume_gradient(unit_cube());
  for (Eigen::Index i = 0; i < 8; ++i) {
    const Vector3 outward = (unit_cube().col(i) - Vector3::Constant(0.5)) / 2;
    BOOST_TEST((gradient.col(i) == outward));
  }
}

// The gradient, too, is linear in every single coordinate: round-off.
BOOST_AUTO_TEST_CASE(hessian_is_the_slope_of_the_gradient) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const CornerPositions x = distorted_cube(seed);
    const auto hessian = mean_edge_volume_hessian(x);
    for (Eigen::Index i = 0; i < 8; ++i)
      for (const Eigen::Index r : coordinates) {
        const Eigen::Matrix<double, 3, 8> column =
            slope([](const CornerPositions& y) { return mean_edge_volume_gradient(y); },
                  x, i, r);
        BOOST_TEST((hessian.col(3 * i + r) - column.reshaped())
                       .norm() < 1e-14);
      }
    BOOST_TEST((hessian - hessian.transpose()).norm() == 0);
  }
}
