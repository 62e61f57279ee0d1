#include "mss/networks/spring_strain.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "tests/mss/blocks.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(spring_strain_test)

namespace {

constexpr Material material{.young_modulus = 1e4, .poisson_ratio = 0.3, .density = 1000};

/// u = H x on 2 x 2 x 2 cubes of the method's springs.
std::vector<double> strains_of(SpringModel model, const Matrix3& H) {
  const Mesh mesh = cube(2, 0.01);
  const Network network = build_network(mesh, material, in_shear_modulus_form(model));
  std::vector<Vector3> u;
  for (const Vector3& X : mesh.nodes()) u.push_back(H * X);
  return largest_spring_strains(network, u);
}

void expect_everywhere(const std::vector<double>& strains, double expected) {
  BOOST_TEST(strains.size() == 8U);
  for (const double e : strains)
    BOOST_TEST(e == expected, boost::test_tools::tolerance(1e-12));
}

/// Simple shear by 20 %: the edges it leaves alone or lengthens by 2 %.
const Matrix3 shear = 0.2 * Vector3::UnitX() * Vector3::UnitZ().transpose();

}  // namespace

// Exact on paper, so the tolerances are round-off alone. Compressed cubes have their most
// strained springs along the load.
BOOST_AUTO_TEST_CASE(stretched_cubes_are_strained_most_along_their_edges) {
  for (const SpringModel model : {SpringModel::cf, SpringModel::nfd, SpringModel::fd})
    for (const double stretch : {-0.3, 0.2}) {
      const Matrix3 H = Vector3(0, 0, stretch).asDiagonal();
      expect_everywhere(strains_of(model, H), stretch);
    }
}

// In simple shear the diagonals of the sheared faces have (1 +- .2, 1) as sides, the
// inner ones (1 +- .2, 1, 1): the strains are of unequal magnitude, and those of
// shortened ones negative.
BOOST_AUTO_TEST_CASE(sheared_cubes_are_strained_most_along_their_diagonals) {
  expect_everywhere(strains_of(SpringModel::cf, shear),
                    std::sqrt((1.2 * 1.2 + 1) / 2) - 1);
  expect_everywhere(strains_of(SpringModel::cf, -shear),
                    std::sqrt((1.2 * 1.2 + 1) / 2) - 1);
}

BOOST_AUTO_TEST_CASE(springs_that_a_method_lacks_have_no_strain) {
  expect_everywhere(strains_of(SpringModel::nfd, shear),
                    std::sqrt((1.2 * 1.2 + 1 + 1) / 3) - 1);
}

// Nearest to x is the dodecahedron's axis (phi, 0, 1/phi)/sqrt 3: a stretch s of x makes
// |F n|^2 = (s^2 phi^2 + 1/phi^2)/3.
BOOST_AUTO_TEST_CASE(virtual_springs_lie_along_the_axes_of_the_dodecahedron_too) {
  constexpr double phi = std::numbers::phi;
  for (const double stretch : {-0.3, 0.2}) {
    const double s = 1 + stretch;
    expect_everywhere(
        strains_of(SpringModel::affine, Vector3(stretch, 0, 0).asDiagonal()),
        std::sqrt((s * s * phi * phi + 1 / (phi * phi)) / 3) - 1);
  }
}

// An hourglass leaves F as it is: the springs of affine rest length that resist it are
// strained, and do not count.
BOOST_AUTO_TEST_CASE(springs_against_hourglasses_do_not_count) {
  const Mesh mesh = cube(1, 0.01);
  std::vector<Vector3> u;
  for (const Vector3& X : mesh.nodes()) {
    const Vector3 side = X.array() - 0.005;
    u.emplace_back(0.001 * (side.x() * side.y() > 0 ? 1 : -1), 0, 0);
  }
  const auto largest = [&](SpringModel model) {
    return largest_spring_strains(
        build_network(mesh, material, in_shear_modulus_form(model)), u);
  };
  BOOST_TEST(std::abs(largest(SpringModel::affine).front()) < 1e-15);
  BOOST_TEST(std::abs(largest(SpringModel::cf).front()) > 0.1);
}

// Exactly; and a tiny strain keeps its digits.
BOOST_AUTO_TEST_CASE(rest_is_without_strain) {
  for (const auto& [name, model] : models_on_cubes)
    for (const double e : strains_of(model, Matrix3::Zero())) BOOST_TEST(e == 0, name);
  for (const double e : strains_of(SpringModel::cf, Vector3(1e-12, 0, 0).asDiagonal()))
    BOOST_TEST(e == 1e-12, boost::test_tools::tolerance(1e-11));
}

BOOST_AUTO_TEST_SUITE_END()
