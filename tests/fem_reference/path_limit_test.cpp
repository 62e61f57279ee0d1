#include <boost/test/unit_test.hpp>

#include "fem_reference/solve.hpp"
#include "statics/last_stable_equilibrium.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"
#include "tests/referee/figures.hpp"

// The places where paths of finite elements lose their stability, by searches to the
// limit.

using namespace springcheck;
using namespace springcheck::fem_reference;
using statics::LinearSolver;

BOOST_AUTO_TEST_SUITE(path_limit_test)

namespace {

Scene compressed(double nu, double strain) {
  return between_plates(of_poisson_ratio(nu), {0, 0, -strain * edge});
}

Solution end_of(const Mesh& mesh, const Scene& scene, const Settings& settings,
                LinearSolver linear_solver = LinearSolver::automatic) {
  return solve(mesh, scene, settings, {.to_limit = true, .linear_solver = linear_solver});
}

/// A body strained along z by sliding plates.
Scene sliding_plates(double nu, double strain) {
  constexpr Held along_normal{false, false, true};
  return {.material = of_poisson_ratio(nu),
          .plates = {{"bottom", translation(Vector3::Zero()), along_normal},
                     {"top", translation({0, 0, strain * edge}), along_normal}},
          .pins = {{.point = Vector3::Zero(), .held = {true, true, false}},
                   {.point = {edge, 0, 0}, .held = {false, true, false}}},
          .gravity = Vector3::Zero()};
}

}  // namespace

BOOST_AUTO_TEST_CASE(st_venant_loses_definiteness_where_the_referee_s_does) {
  const double expected = referee::figure(
      "paths", "compression fem-stvk 6 across nu 0.25 bifurcation", "strain");
  for (const LinearSolver linear_solver :
       {LinearSolver::direct, LinearSolver::conjugate_gradients,
        LinearSolver::multigrid}) {
    const Solution end = end_of(
        cube(6), compressed(0.25, 0.5),
        {.law = Law::st_venant_kirchhoff, .element = Element::q1_sri}, linear_solver);
    BOOST_TEST((end.status == SolveStatus::indefinite), end.reason);
    BOOST_TEST(end.definite_up_to.value() == end.load_fraction);
    BOOST_TEST(0.5 * end.load_fraction <= expected * (1 + 1e-4));  // the referee's own
    BOOST_TEST(0.5 * end.load_fraction >
               expected * (1 - statics::limit_resolution - 1e-4));
    BOOST_TEST(end.critical_wavelength.value() > 4);
    BOOST_TEST(end.factorisations.has_value() == (linear_solver == LinearSolver::direct));
  }
}

BOOST_AUTO_TEST_CASE(a_path_that_stays_stable_reaches_the_full_load) {
  for (const Law law : laws)
    for (const Element element : elements) {
      const Settings settings{.law = law, .element = element};
      const Scene scene = compressed(0.25, 0.05);
      const Solution end = end_of(cube(2), scene, settings),
                     there = solve(cube(2), scene, settings);
      BOOST_TEST((end.status == SolveStatus::ok), end.reason);
      BOOST_TEST(end.load_fraction == 1);
      BOOST_TEST(!end.definite_up_to.has_value());
      BOOST_TEST(end.strain_energy == there.strain_energy,
                 boost::test_tools::tolerance(1e-8));  // residuals of 1e-9
    }
}

// Pushed through each other, sliding plates leave a homogeneous state, whose cells
// Hooke's law, which is linear, turns inside out at -100 %.
BOOST_AUTO_TEST_CASE(cells_turned_inside_out_end_a_path) {
  const Scene sliding = sliding_plates(0, -1.5);
  for (const Element element : {Element::q1, Element::q2}) {
    const Solution end =
        end_of(cube(2), sliding, {.law = Law::hooke, .element = element});
    BOOST_TEST((end.status == SolveStatus::inverted), end.reason);
    BOOST_TEST(1.5 * end.load_fraction <= 1);
    BOOST_TEST(1.5 * end.load_fraction > 1 - statics::limit_resolution);
  }
}

// One end grows thinner, the other thicker. Pins hold a corner, and shift path and mode
// alike.
BOOST_AUTO_TEST_CASE(buckling_of_a_pinned_body_is_no_limit_point) {
  const Solution end = end_of(cube(2), sliding_plates(0, 0.25),
                              {.law = Law::cauchy_born, .element = Element::q1});
  BOOST_TEST((end.status == SolveStatus::indefinite), end.reason);
}

// A uniform bar necks down, and a cube leaves its axis: neither path turns back.
BOOST_AUTO_TEST_CASE(a_path_is_left_where_its_direction_does_not_grow) {
  for (const int cells : {4, 6, 10}) {
    const double width = 1. / cells;
    const Mesh bar = generate_block({.size = {width, width, 1}, .cells = {1, 1, cells}});
    Scene scene = sliding_plates(0, 2 / edge);
    scene.pins.back().point = {width, 0, 0};
    const Solution end = end_of(bar, scene, {.law = Law::hencky, .element = Element::q1});
    BOOST_TEST((end.status == SolveStatus::indefinite), cells << ": " << end.reason);
  }
  const Solution end =
      end_of(cube(2), compressed(0.25, 0.45),
             {.law = Law::st_venant_kirchhoff, .element = Element::q1_sri});
  BOOST_TEST((end.status == SolveStatus::indefinite), end.reason);
}

// Corners alone would show no wave shorter than two edges of whole cells, four between
// nodes.
BOOST_AUTO_TEST_CASE(the_wavelength_on_q2_is_in_edges_between_its_nodes) {
  const Solution end = end_of(cube(4), compressed(0.499, 0.25),
                              {.law = Law::st_venant_kirchhoff, .element = Element::q2});
  BOOST_TEST((end.status == SolveStatus::indefinite), end.reason);
  BOOST_TEST(end.critical_wavelength.value() > 3);
  BOOST_TEST(end.critical_wavelength.value() < 4);
}

BOOST_AUTO_TEST_SUITE_END()
