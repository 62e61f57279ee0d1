#include <boost/test/unit_test.hpp>

#include <numbers>

#include "fem_reference/statics/modes.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tests/fem_reference/bodies.hpp"

using namespace springcheck;
using namespace springcheck::fem_reference;
using std::numbers::pi;
namespace utf = boost::unit_test;

BOOST_AUTO_TEST_SUITE(modes_test)

namespace {

constexpr double E = 1e4, rho = 1000;  // Pa, kg/m^3

Plate plate(const std::string& region, const Held& held) {
  return {.region = region,
          .motion = {.translation = Vector3::Zero(),
                     .axis = Vector3::UnitZ(),
                     .centre = Vector3::Zero(),
                     .angle = 0},
          .held = held};
}

Scene free_body(double nu) {
  return {.material = {.young_modulus = E, .poisson_ratio = nu, .density = rho},
          .plates = {},
          .gravity = Vector3::Zero()};
}

/// A rod whose sides slide along walls, clamped at z = 0: it can only stretch along z.
Scene rod_between_walls() {
  Scene scene = free_body(0);
  scene.plates = {
      plate("bottom", {false, false, true}), plate("x_min", {true, false, false}),
      plate("x_max", {true, false, false}), plate("y_min", {false, true, false}),
      plate("y_max", {false, true, false})};
  return scene;
}

double first_frequency(const Mesh& mesh, const Scene& scene, Element element,
                       MassMatrix mass) {
  return rest_modes(mesh, scene, {.law = Law::hooke, .element = element}, mass, 1)
      .value()
      .frequencies[0];
}

}  // namespace

// Linear elements in a row, c = sqrt(E/rho), theta = pi/(2n):
//
//     consistent  omega = (c/h) sqrt(6 (1 - cos theta)/(2 + cos theta)),
//     lumped      omega = (2c/h) sin(theta/2)
//
// (Hughes, The Finite Element Method (1987), section 7.3.2): above and below the rod's
// pi c/(2L), off by theta^2/24 to first order. Exact, so round-off; the shift costs six
// digits.
BOOST_AUTO_TEST_CASE(a_rod_s_first_frequency_is_bracketed, *utf::tolerance(1e-8)) {
  const double h = 0.01, c = std::sqrt(E / rho);
  for (const int n : {4, 8}) {
    const Mesh rod = generate_block({.size = {h, h, n * h}, .cells = {1, 1, n}});
    const double theta = pi / (2 * n), exact = c / (4 * n * h);
    const auto omega = [&](Element element, MassMatrix mass) {
      return 2 * pi * first_frequency(rod, rod_between_walls(), element, mass);
    };
    for (const Element element : {Element::q1, Element::q1_sri}) {
      BOOST_TEST(omega(element, MassMatrix::consistent) ==
                 c / h * std::sqrt(6 * (1 - std::cos(theta)) / (2 + std::cos(theta))));
      BOOST_TEST(omega(element, MassMatrix::lumped) == 2 * c / h * std::sin(theta / 2));
    }
    // Quadratic elements err by theta^4.
    BOOST_TEST(omega(Element::q2, MassMatrix::consistent) == 2 * pi * exact,
               boost::test_tools::tolerance(std::pow(theta, 4) / 100));
  }
}

// Rayleigh's principle: with everything integrated exactly, as on undistorted cells by
// q1, any mesh's frequencies are upper bounds that fall by h^2. The limit is that of
// Rayleigh and Ritz on the same cube at nu = .25, 18.1810 Hz (recorded: free_block_modes
// with polynomials up to degree 13). The band of the ratio is for coarse meshes.
BOOST_AUTO_TEST_CASE(consistent_frequencies_fall_to_the_limit_on_any_cells) {
  const double limit = 18.1810;
  for (const CellPattern pattern : patterns) {
    const auto error = [&](int cells) {
      return first_frequency(cube(cells, pattern), free_body(0.25), Element::q1,
                             MassMatrix::consistent) -
             limit;
    };
    const double coarse = error(4), fine = error(8);
    BOOST_TEST(fine > 0, words(pattern));
    BOOST_TEST(coarse / fine > 3, words(pattern) << " " << coarse / fine);
    BOOST_TEST(coarse / fine < 5, words(pattern) << " " << coarse / fine);
  }
}

BOOST_AUTO_TEST_CASE(a_free_body_has_six_rigid_modes_and_lumping_lowers_the_others) {
  for (const CellPattern pattern : patterns)
    for (const Element element : elements_on(pattern)) {
      const auto modes = [&](MassMatrix mass) {
        return rest_modes(cube(3, pattern, 0.1), free_body(0.25),
                          {.law = Law::hooke, .element = element}, mass, 8)
            .value();
      };
      const NaturalModes consistent = modes(MassMatrix::consistent),
                         lumped = modes(MassMatrix::lumped);
      BOOST_TEST(consistent.zero_modes == 6);
      BOOST_TEST(lumped.zero_modes == 6);
      for (int i = 0; i < 8; ++i)
        BOOST_TEST(lumped.frequencies[i] < consistent.frequencies[i],
                   words(pattern) << " " << words(element));
    }
}

// At rest all laws are Hooke's, to round-off.
BOOST_AUTO_TEST_CASE(every_law_swings_alike_at_rest, *utf::tolerance(1e-7)) {
  Scene scene = free_body(0.3);
  scene.plates = {plate("bottom", all_components)};
  std::vector<double> found;
  for (const Law law : {Law::hooke, Law::st_venant_kirchhoff, Law::hencky}) {
    const auto modes = rest_modes(cube(3), scene, {.law = law, .element = Element::q1},
                                  MassMatrix::consistent, 1);
    BOOST_TEST(modes.value().zero_modes == 0);
    found.push_back(modes->frequencies[0]);
    const NodeIndex held = cube(3).region("bottom").nodes.front();
    BOOST_TEST(modes->shapes.col(0).segment<3>(3 * held).norm() == 0);
  }
  BOOST_TEST(found[0] == found[1]);
  BOOST_TEST(found[0] == found[2]);
}

BOOST_AUTO_TEST_SUITE_END()
