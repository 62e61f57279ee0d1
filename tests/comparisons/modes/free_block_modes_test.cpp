#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

#include "comparisons/modes/free_block_modes.hpp"
#include "fem_reference/statics/modes.hpp"
#include "meshing/generators/generate_block.hpp"

using namespace springcheck;
namespace utf = boost::unit_test;

BOOST_AUTO_TEST_SUITE(free_block_modes_test)

namespace {

constexpr double edge = 0.05;  // m
constexpr std::array<double, 3> cube_size{edge, edge, edge};

Material soft(double nu) {
  return {.young_modulus = 1e4, .poisson_ratio = nu, .density = 1000};
}

NaturalModes cube_modes(double nu, int degree, int count) {
  return free_block_modes(cube_size, soft(nu), degree, count, {});
}

}  // namespace

// Lame's three modes, exact; cosines by polynomials of degree 10 to 1e-8. At nu = 0 some
// others have their frequency too.
BOOST_AUTO_TEST_CASE(lame_s_modes_are_among_a_cube_s) {
  for (const double nu : {0., 0.25, 0.4}) {
    const double lame =
        std::sqrt(lame_constants(soft(nu)).mu / 1000) / (std::numbers::sqrt2 * edge);
    const auto modes = cube_modes(nu, 10, 25);
    const auto off = (modes.frequencies.array() / lame - 1).abs();
    BOOST_TEST((off < 1e-8).count() == (nu == 0 ? 6 : 3));
  }
}

// Bounds fall with the degree; two more change 6e-4 from the eighth on, 3e-5 from the
// tenth.
BOOST_AUTO_TEST_CASE(frequencies_fall_to_a_limit) {
  for (const double nu : {0., 0.25, 0.4}) {
    const auto coarse = cube_modes(nu, 8, 10).frequencies,
               fine = cube_modes(nu, 10, 10).frequencies;
    for (int i = 0; i < 10; ++i) {
      BOOST_TEST(fine[i] <= coarse[i] * (1 + 1e-12));
      BOOST_TEST(fine[i] == coarse[i], boost::test_tools::tolerance(7e-4));
    }
  }
}

// Finite elements share no code with it. Their error falls as h^2 to its limit; the first
// eight, whose order is the same on all grids.
BOOST_AUTO_TEST_CASE(finite_elements_approach_it) {
  const auto limit = cube_modes(0.25, 10, 10).frequencies;
  const auto elements = [&](int cells) {
    const Mesh mesh = generate_block({.size = cube_size, .cells = {cells, cells, cells}});
    const Scene scene{.material = soft(0.25), .plates = {}, .gravity = Vector3::Zero()};
    return fem_reference::rest_modes(mesh, scene,
                                     {.law = fem_reference::Law::hooke,
                                      .element = fem_reference::Element::q1_sri},
                                     fem_reference::MassMatrix::consistent, 10)
        .value()
        .frequencies;
  };
  const Eigen::VectorXd coarse = elements(5) - limit, fine = elements(10) - limit;
  for (int i = 0; i < 8; ++i) {
    BOOST_TEST(fine[i] > 0);
    BOOST_TEST(coarse[i] / fine[i] > 3.6, i << " " << coarse[i] / fine[i]);
    BOOST_TEST(coarse[i] / fine[i] < 4.4, i << " " << coarse[i] / fine[i]);
  }
}

// Shapes are mass-normalised: over a fine grid of midpoints int rho u.u dV is 1 up to its
// h^2 error.
BOOST_AUTO_TEST_CASE(shapes_are_normalised_by_mass, *utf::tolerance(0.02)) {
  constexpr int n = 20;
  const std::array<double, 3> size{0.04, 0.05, 0.06};
  std::vector<Vector3> points;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        points.emplace_back((x + .5) / n * size[0], (y + .5) / n * size[1],
                            (z + .5) / n * size[2]);
  const auto modes = free_block_modes(size, soft(0.25), 6, 3, points);
  const double mass = 1000 * size[0] * size[1] * size[2] / (n * n * n);
  for (int i = 0; i < 3; ++i) BOOST_TEST(mass * modes.shapes.col(i).squaredNorm() == 1.);
}

BOOST_AUTO_TEST_SUITE_END()
