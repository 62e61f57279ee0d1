#include <boost/test/unit_test.hpp>

#include <numbers>

#include "meshing/generators/generate_block.hpp"
#include "mss/statics/modes.hpp"
#include "tests/mss/blocks.hpp"

using namespace springcheck;
using namespace springcheck::mss;
namespace utf = boost::unit_test;

BOOST_AUTO_TEST_SUITE(modes_test)

namespace {

constexpr Material soft{.young_modulus = 1e4, .poisson_ratio = 0.3, .density = 1000};

double square(double frequency) {
  return std::pow(2 * std::numbers::pi * frequency, 2);
}

std::optional<NaturalModes> free_modes(const Mesh& mesh, const Material& material,
                                       const NetworkSettings& settings, int count) {
  return rest_modes(build_network(mesh, material, settings),
                    std::vector<bool>(3 * mesh.nodes().size(), true), count);
}

}  // namespace

// One cube of edges alone, k/4 of each node's mass m. The four edges along x join the
// planes x = 0 and x = h: each swings by itself with omega^2 = 2 (k/4)/m, for 12 edges
// 12 times; what no edge resists are 24 - 12 = 12 motions. Exact; the shift costs six
// digits of round-off.
BOOST_AUTO_TEST_CASE(edges_of_a_cube_swing_each_by_itself, *utf::tolerance(1e-8)) {
  const double h = 0.05, k = 3;  // m, N/m
  const auto modes =
      free_modes(cube(1, h), soft,
                 custom({.edge = k, .face_diagonal = 0, .inner_diagonal = 0}, 0), 20)
          .value();
  const double m = soft.density * h * h * h / 8;
  BOOST_TEST(modes.zero_modes == 12);
  BOOST_TEST_REQUIRE(modes.frequencies.size() == 12);
  for (const double f : modes.frequencies) BOOST_TEST(square(f) == 2 * (k / 4) / m);
}

// A free body has six rigid modes and no others, but for mss-nfd, whose lattice leaves
// three hourglasses free whatever the number of cells.
BOOST_AUTO_TEST_CASE(a_free_cube_has_six_modes_of_zero_frequency) {
  for (const int n : {2, 4})
    for (const double nu : {0., 0.25, 0.45})
      for (const auto& [name, model] : {NamedModel{"mss-cf", SpringModel::cf},
                                        {"mss-affine", SpringModel::affine},
                                        {"mss-nfd", SpringModel::nfd}}) {
        Material material = soft;
        material.poisson_ratio = nu;
        const auto modes =
            free_modes(cube(n, 0.01), material, in_shear_modulus_form(model), 4).value();
        BOOST_TEST(modes.zero_modes == (model == SpringModel::nfd ? 9 : 6),
                   name << " " << n << " " << nu);
      }
}

BOOST_AUTO_TEST_CASE(affine_springs_have_modes_on_any_cells) {
  for (const CellPattern pattern : {CellPattern::tetrahedron, CellPattern::prism,
                                    CellPattern::pyramid, CellPattern::mixed}) {
    const Mesh mesh = generate_block({.size = {0.1, 0.1, 0.1},
                                      .cells = {3, 3, 3},
                                      .pattern = pattern,
                                      .distortion = 0.1});
    const auto modes =
        free_modes(mesh, soft, in_shear_modulus_form(SpringModel::affine), 4).value();
    BOOST_TEST(modes.zero_modes == 6);
    BOOST_TEST(modes.frequencies[0] > 0);
  }
}

// A rod of cubes at nu = 0 between sliding walls stretches like a chain of masses rho h^3
// and springs E h, half a mass at its free end: omega = 2 sqrt(E/(rho h^2))
// sin((2j - 1) pi/(4 n)). Round-off as above.
BOOST_AUTO_TEST_CASE(a_held_rod_stretches_like_a_chain, *utf::tolerance(1e-7)) {
  constexpr int n = 12;
  const double h = 0.01;
  const Material material{.young_modulus = 1e4, .poisson_ratio = 0, .density = 1000};
  const Mesh rod = generate_block({.size = {h, h, n * h}, .cells = {1, 1, n}});
  std::vector<bool> is_free(3 * rod.nodes().size(), false);
  for (NodeIndex node = 0; node < rod.nodes().size(); ++node)
    is_free[3 * node + 2] = rod.nodes()[node].z() > 0;
  const Network network =
      build_network(rod, material, in_shear_modulus_form(SpringModel::cf));
  const auto modes = rest_modes(network, is_free, 1).value();
  const double omega =
      2 * std::sqrt(1e4 / 1000) / h * std::sin(std::numbers::pi / (4 * n));
  BOOST_TEST(modes.zero_modes == 0);
  BOOST_TEST(2 * std::numbers::pi * modes.frequencies[0] == omega);
  // Prescribed components do not move, and the masses are normalised.
  double mass = 0;
  for (std::size_t i = 0; i < is_free.size(); ++i) {
    const double x = modes.shapes(static_cast<Eigen::Index>(i), 0);
    if (!is_free[i]) BOOST_TEST(x == 0);
    mass += network.masses[i / 3] * x * x;
  }
  BOOST_TEST(mass == 1.);
}

BOOST_AUTO_TEST_CASE(an_unstable_lattice_has_no_modes) {
  const LatticeStiffness springs{.edge = 3, .face_diagonal = 1, .inner_diagonal = 1};
  BOOST_TEST(!free_modes(cube(2, 0.05), soft, custom(springs, -1e5), 4).has_value());
}

BOOST_AUTO_TEST_SUITE_END()
