#include "fem_reference/explicit/explicit_dynamics.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "fem_reference/motion/drag.hpp"
#include "fem_reference/solve.hpp"
#include "tests/dynamics/marching/beside_limit.hpp"
#include "tests/fem_reference/explicit/fields.hpp"
#include "tests/fem_reference/laws.hpp"

using namespace springcheck;
using namespace springcheck::fem_reference;
using dynamics::Integrator;

BOOST_AUTO_TEST_SUITE(dynamics_test)

namespace {

const Material tissue = of_poisson_ratio(0.25);

/// Semi-implicit Euler; no step: of its own choice.
ExplicitSettings steps(ExplicitElement element, double duration,
                       std::optional<double> time_step, double damping_ratio) {
  return {.element = element,
          .protocol = {.integrator = Integrator::semi_implicit_euler,
                       .duration = duration,
                       .time_step = time_step,
                       .force_time_step = false},
          .damping_ratio = damping_ratio};
}

Scene between_plates_moved(const Vector3& way) {
  return {.material = tissue,
          .plates = {{"bottom", moved_by({0, 0, 0}), all_components},
                     {"top", moved_by(way), all_components}},
          .gravity = Vector3::Zero()};
}

/// Root of the sum of squares of the distances between two states, over `scale`.
double distance(const Solution& a, const Solution& b, double scale) {
  double squares = 0;
  for (std::size_t n = 0; n < a.displacements.size(); ++n)
    squares += (a.displacements[n] - b.displacements[n]).squaredNorm();
  return std::sqrt(squares) / scale;
}

double force_on_top(const Mesh& mesh, const Solution& solution) {
  double force = 0;
  for (const NodeIndex node : mesh.region("top").nodes)
    force += solution.reactions[node].z();
  return force;
}

}  // namespace

// v += dt g n/N and x += dt v over N steps, summed by hand: g dt^2 (N+1)(N+2)/6. The
// block falls without strain, so the tolerance is round-off of N additions.
BOOST_AUTO_TEST_CASE(block_without_plates_falls_freely) {
  const Vector3 g(3, 0, -10);
  const Scene scene{.material = tissue, .plates = {}, .gravity = g};
  const Vector3 fallen = g * 0.001 * 0.001 * 101 * 102 / 6;
  for (const Mesh& mesh : {cube(3), distorted_cube(3, 0.2, Moved::all_nodes)})
    for (const ExplicitElement element : explicit_elements) {
      const Solution solution = run_dynamics(mesh, scene, steps(element, 0.1, 0.001, 0));
      BOOST_TEST((solution.status == SolveStatus::ok), solution.reason);
      BOOST_TEST(solution.steps == 100);
      for (const Vector3& u : solution.displacements)
        BOOST_TEST((u - fallen).norm() < 1e-14);
    }
}

// The same with the drag: v += dt (g n/N - alpha v), by the same steps for one number.
BOOST_AUTO_TEST_CASE(drag_slows_a_falling_block, *boost::unit_test::tolerance(1e-11)) {
  const Scene scene{.material = tissue, .plates = {}, .gravity = {0, 0, -10}};
  // c_s = 2 m/s and L = .05 m: 2 * .1 * pi * 2/.05 = 8 pi.
  const double alpha = drag_rate(cube(2), tissue, 0.1);
  BOOST_TEST(alpha == 8 * std::numbers::pi);
  double z = 0, v = 0;
  for (int n = 1; n <= 100; ++n) {
    v += 0.001 * (-10 * n / 100. - alpha * v);
    z += 0.001 * v;
  }
  for (const Mesh& mesh : {cube(10), cube(2, CellPattern::free_hexahedron)})
    for (const Vector3& u :
         run_dynamics(mesh, scene, steps(ExplicitElement::one_point, 0.1, 0.001, 0.1))
             .displacements)
      BOOST_TEST(u.z() == z);
}

// Slowly and with a drag the block is led through its equilibria, those of the implicit
// solver's q1. The drag's part falls with the speed of the plate.
BOOST_AUTO_TEST_CASE(slow_dynamics_of_eight_points_ends_near_the_implicit_solution) {
  const double way = 0.05 * edge;
  const Scene scene = between_plates_moved({0, 0, -way});
  for (const Mesh& mesh : {cube(3), distorted_cube(3, 0.2, Moved::interior_nodes)}) {
    const Solution rest =
        solve(mesh, scene, {.law = Law::st_venant_kirchhoff, .element = Element::q1});
    const auto lag = [&](double duration) {
      return distance(
          run_dynamics(mesh, scene,
                       steps(ExplicitElement::eight_points, duration, std::nullopt, 0.5)),
          rest, way);
    };
    const double in_two_seconds = lag(2), in_eight_seconds = lag(8);
    BOOST_TEST(in_two_seconds < 2e-2);
    BOOST_TEST(in_eight_seconds == in_two_seconds / 4, boost::test_tools::tolerance(0.1));
  }
}

// One point with hourglass control and q1-sri are two discretisations of one body: their
// plate forces differ by what either is off, and by less on finer cells (measured: .25 %
// on 3^3 cells, .12 % on 6^3).
BOOST_AUTO_TEST_CASE(one_point_agrees_with_selective_integration_under_refinement) {
  const Scene scene = between_plates_moved({0, 0, -0.05 * edge});
  const auto difference = [&](int cells) {
    const Mesh mesh = cube(cells);
    const Solution rest =
        solve(mesh, scene, {.law = Law::st_venant_kirchhoff, .element = Element::q1_sri});
    const Solution end = run_dynamics(
        mesh, scene, steps(ExplicitElement::one_point, 20, std::nullopt, 0.5));
    return std::abs(force_on_top(mesh, end) / force_on_top(mesh, rest) - 1);
  };
  const double coarse = difference(3), fine = difference(6);
  BOOST_TEST(coarse < 0.005);
  BOOST_TEST(fine < 0.6 * coarse);
}

// The real thing: 2 % below the limit the motion stays of the size of what is imposed,
// and 2 % above it it is found to be unstable: out of all bounds, or turned round from
// step to step. Plate and gravity are oblique, to stir modes of every symmetry.
BOOST_AUTO_TEST_CASE(dynamics_is_stable_below_the_limit_and_diverged_above) {
  constexpr double squeeze = 1e-4;  // [m]
  for (const Mesh& mesh : {cube(3), distorted_cube(3, 0.2, Moved::interior_nodes)})
    for (const ExplicitElement element : explicit_elements)
      for (const Integrator integrator :
           {Integrator::semi_implicit_euler, Integrator::verlet})
        for (const double nu : {0., 0.25, 0.4, 0.499})
          for (const double damping : {0., 0.05, 1.}) {
            Scene scene = between_plates_moved(squeeze * Vector3(.4, .3, -1));
            scene.material = of_poisson_ratio(nu);
            scene.gravity = {.1, .2, .3};
            ExplicitSettings settings = steps(element, 1, std::nullopt, damping);
            settings.protocol.integrator = integrator;
            const double limit = largest_stable_step(mesh, scene, settings);
            BOOST_TEST_CONTEXT(words(element) << ", nu " << nu << ", zeta " << damping) {
              dynamics::expect_stability_up_to(limit, integrator, 2 * squeeze,
                                               [&](const dynamics::Protocol& protocol) {
                                                 settings.protocol = protocol;
                                                 return run_dynamics(mesh, scene,
                                                                     settings);
                                               });
            }
          }
}

// A unit in the last place of a float, over a thousand damped steps (measured: 3e-7).
BOOST_AUTO_TEST_CASE(single_precision_ends_where_double_does) {
  const Mesh mesh = distorted_cube(3, 0.2, Moved::interior_nodes);
  const double way = 0.05 * edge;
  const Scene scene = between_plates_moved({0, 0, -way});
  for (const ExplicitElement element : explicit_elements) {
    ExplicitSettings settings = steps(element, 1, 1e-3, 0.5);
    const Solution exact = run_dynamics(mesh, scene, settings);
    settings.precision = dynamics::Precision::single_precision;
    const Solution rounded = run_dynamics(mesh, scene, settings);
    BOOST_TEST((exact.status == SolveStatus::ok), exact.reason);
    BOOST_TEST((rounded.status == SolveStatus::ok), rounded.reason);
    BOOST_TEST(distance(exact, rounded, way) < 3e-6);
  }
}

BOOST_AUTO_TEST_CASE(what_they_do_not_cover_is_refused_with_a_reason) {
  const Scene scene = between_plates_moved({0, 0, 0});
  ExplicitSettings settings = steps(ExplicitElement::one_point, 1, std::nullopt, 0);
  const Solution tetrahedra =
      run_dynamics(cube(2, CellPattern::tetrahedron), scene, settings);
  BOOST_TEST((tetrahedra.status == SolveStatus::refused));
  BOOST_TEST(tetrahedra.reason.find("hexahedra") != std::string::npos);
  settings.protocol.integrator = Integrator::implicit_euler;
  const Solution implicit = run_dynamics(cube(2), scene, settings);
  BOOST_TEST((implicit.status == SolveStatus::refused));
  BOOST_TEST(implicit.reason.find("step explicitly") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
