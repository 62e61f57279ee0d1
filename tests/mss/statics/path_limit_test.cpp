#include "statics/path_limit.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <numbers>
#include <tuple>

#include "meshing/generators/generate_block.hpp"
#include "meshing/wavelength.hpp"
#include "mss/statics/equilibrium.hpp"
#include "statics/systems/nodal_vectors.hpp"
#include "tests/mss/path_limits.hpp"
#include "tests/mss/spring_runs.hpp"
#include "tests/referee/figures.hpp"

using namespace springcheck;
using namespace springcheck::mss;
using statics::PathEnd, statics::PathLimit;

BOOST_AUTO_TEST_SUITE(path_limit_test)

namespace {

constexpr double h = 0.005;  // m, the cells' edge
constexpr statics::Search to_limit{.to_limit = true};

/// Load fraction at which the path ends, as a strain of the height [%].
double limit_in_percent(const Mesh& mesh, SpringModel model, double nu, double percent,
                        SolveStatus expected, double shortest, double longest) {
  const Network network =
      build_network(mesh, tissue_of(nu), in_shear_modulus_form(model));
  double height = 0;
  for (const Vector3& x : mesh.nodes()) height = std::max(height, x.z());
  const Solution end = find_equilibrium(
      mesh, between_plates(tissue_of(nu), {0, 0, percent / 100 * height}), network,
      to_limit);
  BOOST_TEST((end.status == expected), end.reason);
  BOOST_TEST_REQUIRE(end.critical_wavelength.has_value());
  BOOST_TEST(*end.critical_wavelength >= shortest);
  BOOST_TEST(*end.critical_wavelength <= longest);
  return std::abs(percent) * end.load_fraction;
}

/// The referee's, by bisection of its path at which an eigenvalue is lost, a cell turns
/// inside out or no equilibrium is found; ours to a hundredth of itself.
double of_the_referee(const std::string& of_case) {
  return referee::figure("paths", of_case,
                         of_case.starts_with("torsion") ? "degrees" : "strain");
}

struct Limit {
  const char* name;
  SpringModel model;
  double nu, tried;  // [%], negative in compression
};

}  // namespace

// The limits are those of 10^3 cells.
BOOST_AUTO_TEST_CASE(lattices_without_diagonals_wrinkle_in_compression) {
  const Mesh mesh = cube(10, h);
  for (const auto& [name, model, nu, tried] :
       {Limit{"mss-nfd", SpringModel::nfd, 0, -3},
        Limit{"mss-nfd", SpringModel::nfd, .25, -3},
        Limit{"mss-nfd", SpringModel::nfd, .499, -4},
        Limit{"mss-baudet", SpringModel::baudet, 0, -5}})
    BOOST_TEST(limit_in_percent(mesh, model, nu, tried, SolveStatus::indefinite, 2, 4) ==
                   100 * of_the_referee(
                             fmt::format("compression {} nu {} bifurcation", name, nu)),
               boost::test_tools::tolerance(.01));
}

// The limits are those of 10^3 cells.
BOOST_AUTO_TEST_CASE(mss_cf_buckles_or_is_turned_inside_out_in_compression) {
  const Mesh mesh = cube(10, h);
  for (const auto& [nu, expected, how] :
       {std::tuple(0., SolveStatus::indefinite, "bifurcation"),
        std::tuple(.25, SolveStatus::indefinite, "bifurcation"),
        std::tuple(.499, SolveStatus::inverted, "inversion")})
    BOOST_TEST(
        limit_in_percent(mesh, SpringModel::cf, nu, -50, expected, 4, 100) ==
            100 * of_the_referee(fmt::format("compression mss-cf nu {} {}", nu, how)),
        boost::test_tools::tolerance(.01));
}

// The limit is that of the thesis's beam.
BOOST_AUTO_TEST_CASE(mss_cf_has_no_equilibrium_in_long_tension) {
  const Mesh beam = generate_block({.size = {4 * h, 4 * h, 24 * h}, .cells = {4, 4, 24}});
  for (const double nu : {0., .1}) {
    const Network network =
        build_network(beam, tissue_of(nu), in_shear_modulus_form(SpringModel::cf));
    const Solution end = find_equilibrium(
        beam, between_plates(tissue_of(nu), {0, 0, .5 * 24 * h}), network, to_limit);
    BOOST_TEST((end.status == SolveStatus::no_equilibrium), end.reason);
    BOOST_TEST(.5 * end.load_fraction ==
                   of_the_referee(fmt::format("tension mss-cf nu {} no equilibrium", nu)),
               boost::test_tools::tolerance(.01));
  }
}

// Bending is so soft in a slender body that what turns its path back, a millionth of the
// load away, still has a tenth of the least curvature at rest, but not of its own.
BOOST_AUTO_TEST_CASE(a_slender_body_s_path_turns_back) {
  const auto end_of = [](SpringModel model, double nu, std::array<int, 3> cells) {
    const std::array<double, 3> size{cells[0] * h, cells[1] * h, cells[2] * h};
    const Mesh beam = generate_block({.size = size, .cells = cells});
    const Network network =
        build_network(beam, tissue_of(nu), in_shear_modulus_form(model));
    const Vector3 way(0, 0, .6 * size[2]);
    return find_equilibrium(beam, between_plates(tissue_of(nu), way), network, to_limit);
  };
  for (const Solution& end : {end_of(SpringModel::nfd, .05, {4, 4, 24}),
                              end_of(SpringModel::cf, .08, {3, 3, 18}),
                              end_of(SpringModel::cf, .1, {3, 3, 30})})
    BOOST_TEST((end.status == SolveStatus::no_equilibrium), end.reason);
}

BOOST_AUTO_TEST_CASE(mss_cf_in_torsion_holds_as_far_as_the_referee_s) {
  const Mesh mesh = cube(6, h);
  for (const double nu : {0., .1, .25, .4}) {
    const Network network =
        build_network(mesh, tissue_of(nu), in_shear_modulus_form(SpringModel::cf));
    Scene scene = between_plates(tissue_of(nu), Vector3::Zero());
    scene.plates[1].motion = {.translation = Vector3::Zero(),
                              .axis = Vector3::UnitZ(),
                              .centre = {3 * h, 3 * h, 6 * h},
                              .angle = std::numbers::pi};
    const Solution end = find_equilibrium(mesh, scene, network, to_limit);
    BOOST_TEST(180 * end.load_fraction ==
                   of_the_referee(fmt::format("torsion mss-cf nu {} bifurcation", nu)),
               boost::test_tools::tolerance(.01));
  }
}

// Plates turned by 370 degrees lie where 10 would bring them. The body has two layers of
// cells.
BOOST_AUTO_TEST_CASE(a_limit_in_torsion_does_not_depend_on_the_turn_asked_for) {
  const Mesh mesh = cube(2, h);
  const Network network =
      build_network(mesh, tissue_of(.25), in_shear_modulus_form(SpringModel::cf));
  const auto limit = [&](double degrees) {
    Scene scene = between_plates(tissue_of(.25), Vector3::Zero());
    scene.plates[1].motion = {.translation = Vector3::Zero(),
                              .axis = Vector3::UnitZ(),
                              .centre = {h, h, 2 * h},
                              .angle = degrees * std::numbers::pi / 180};
    const Solution end = find_equilibrium(mesh, scene, network, to_limit);
    BOOST_TEST((end.status == SolveStatus::indefinite), end.reason);
    return degrees * end.load_fraction;
  };
  for (const double degrees : {200., 370., -720.})
    BOOST_TEST(std::abs(limit(degrees)) == limit(170), boost::test_tools::tolerance(.01));
}

// Isochoric springs lose a mode of few nodes whose curvature is a third of that at rest
// until within .2 % of the load.
BOOST_AUTO_TEST_CASE(
    a_mode_of_few_nodes_is_found_where_it_is_stiff_until_shortly_before) {
  NetworkSettings settings = in_shear_modulus_form(SpringModel::affine);
  settings.strain_measure = StrainMeasure::hencky;
  settings.axes = Axes::twenty_five;
  const Mesh mesh = cube(6, h);
  const Network network = build_network(mesh, tissue_of(.4), settings);
  const PathLimit limit =
      limit_of(mesh, between_plates(tissue_of(.4), {0, 0, -.6 * 6 * h}), network, .002);
  BOOST_TEST((limit.end == PathEnd::bifurcation));
  BOOST_TEST(limit.curvature < .1 * limit.rest_curvature);
  BOOST_TEST(limit.next_load_fraction - limit.load_fraction < .001 * limit.load_fraction);
  BOOST_TEST(shortest_wavelength(mesh.cells(), mesh.nodes(),
                                 statics::by_node(limit.critical_mode)) < 4);
}

BOOST_AUTO_TEST_CASE(a_path_without_a_limit_reaches_the_full_load) {
  const Mesh mesh = cube(3, h);
  const Network network =
      build_network(mesh, tissue_of(.25), in_shear_modulus_form(SpringModel::cf));
  const PathLimit limit =
      limit_of(mesh, between_plates(tissue_of(.25), {0, 0, -.1 * 3 * h}), network, .01);
  BOOST_TEST((limit.end == PathEnd::full_load));
  BOOST_TEST(limit.load_fraction == 1);
  BOOST_TEST(limit.next_load_fraction == 1);
}

BOOST_AUTO_TEST_CASE(a_state_tried_in_vain_is_forgotten_at_the_full_load) {
  const Mesh mesh = cube(3, h);
  const Network network =
      build_network(mesh, tissue_of(.25), in_shear_modulus_form(SpringModel::cf));
  int tries = 0;
  const PathLimit limit =
      limit_of(mesh, between_plates(tissue_of(.25), {0, 0, -.1 * h}), network, .01,
               [&](const Eigen::VectorXd&, double) { return ++tries != 3; });
  BOOST_TEST((limit.end == PathEnd::full_load));
  BOOST_TEST(limit.next_load_fraction == 1);
}

// A caller's refusal is found to the resolution, wherever it begins.
BOOST_AUTO_TEST_CASE(a_state_that_is_not_accepted_ends_the_path) {
  const Mesh mesh = cube(3, h);
  const Network network =
      build_network(mesh, tissue_of(.25), in_shear_modulus_form(SpringModel::cf));
  const auto top = static_cast<Eigen::Index>(
      std::ranges::max_element(mesh.nodes(), {}, [](const Vector3& x) { return x.z(); }) -
      mesh.nodes().begin());
  const double height = 3 * h;
  const PathLimit limit = limit_of(
      mesh, between_plates(tissue_of(.25), {0, 0, -.1 * height}), network, .001,
      [&](const Eigen::VectorXd& u, double) { return u[3 * top + 2] > -.0437 * height; });
  BOOST_TEST((limit.end == PathEnd::rejected));
  BOOST_TEST(limit.load_fraction == .437, boost::test_tools::tolerance(.0011));
  BOOST_TEST(limit.load_fraction < .437);
  BOOST_TEST(limit.next_load_fraction >= .437);
}

// The waves run along an edge of the lattice, between plates far away.
BOOST_AUTO_TEST_CASE(the_wavelength_of_a_wave_is_found) {
  const Mesh mesh = cube(24, h);
  for (const int length : {2, 3, 4, 6, 8, 12}) {
    std::vector<Vector3> wave;
    for (const Vector3& x : mesh.nodes())
      wave.emplace_back(std::cos(2 * std::numbers::pi * x.x() / (length * h)), 0, 0);
    // The ends of lines weigh half of a node inside: of 24 cells a few per cent.
    BOOST_TEST(shortest_wavelength(mesh.cells(), mesh.nodes(), wave) == length,
               boost::test_tools::tolerance(.03));
  }
}

BOOST_AUTO_TEST_SUITE_END()
