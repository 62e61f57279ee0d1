#include "fem_reference/motion/moving_elements.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "fem_reference/explicit/explicit_dynamics.hpp"
#include "fem_reference/motion/drag.hpp"
#include "fem_reference/solve.hpp"
#include "tests/dynamics/marching/beside_limit.hpp"
#include "tests/fem_reference/explicit/fields.hpp"
#include "tests/fem_reference/laws.hpp"

using namespace springcheck;
using namespace springcheck::fem_reference;
using dynamics::Integrator;

BOOST_AUTO_TEST_SUITE(moving_elements_test)

namespace {

/// Semi-implicit Euler; no step: of its own choice.
MotionSettings settings_of(Law law, Element element, double duration,
                           std::optional<double> time_step, double damping_ratio) {
  return {.elements = {.law = law, .element = element},
          .protocol = {.integrator = Integrator::semi_implicit_euler,
                       .duration = duration,
                       .time_step = time_step,
                       .force_time_step = false},
          .damping_ratio = damping_ratio};
}

Scene with_top_moved(const Vector3& way, double nu = 0.25) {
  return {.material = of_poisson_ratio(nu),
          .plates = {{"bottom", moved_by({0, 0, 0}), all_components},
                     {"top", moved_by(way), all_components}},
          .gravity = Vector3::Zero()};
}

double farthest(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  double distance = 0;
  for (std::size_t n = 0; n < a.size(); ++n)
    distance = std::max(distance, (a[n] - b[n]).norm());
  return distance;
}

constexpr Element moving[] = {Element::q1, Element::q1_sri, Element::q1_nodal};
constexpr CellPattern others[] = {CellPattern::tetrahedron, CellPattern::mixed};

}  // namespace

// Two codes for one element, and for its masses and its drag: what is left is rounding,
// which 300 steps of a damped motion do not enlarge.
BOOST_AUTO_TEST_CASE(trilinear_hexahedra_of_st_venant_move_as_their_kernel_moves_them) {
  const Mesh mesh = distorted_cube(3, 0.2, Moved::interior_nodes);
  Scene scene = with_top_moved(0.05 * edge * Vector3(.4, .3, -1));
  scene.gravity = {3, 2, -10};
  scene.tractions = {{.region = "x_max", .stress = {200, 0, -100}}};
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::verlet,
                                      Integrator::explicit_euler}) {
    MotionSettings by_loops =
        settings_of(Law::st_venant_kirchhoff, Element::q1, 0.12, 4e-4, 0.3);
    by_loops.protocol.integrator = integrator;
    const ExplicitSettings by_kernel{.element = ExplicitElement::eight_points,
                                     .protocol = by_loops.protocol,
                                     .damping_ratio = by_loops.damping_ratio};
    const Solution a = run_dynamics(mesh, scene, by_loops),
                   b = run_dynamics(mesh, scene, by_kernel);
    BOOST_TEST((a.status == SolveStatus::ok), a.reason);
    BOOST_TEST(a.steps == 300);
    BOOST_TEST(longest(b.displacements) > 0.05 * edge);
    BOOST_TEST(farthest(a.displacements, b.displacements) <
               1e-12 * longest(b.displacements));
    BOOST_TEST(farthest(a.reactions, b.reactions) < 1e-11 * longest(b.reactions));
  }
}

BOOST_AUTO_TEST_CASE(their_largest_steps_are_the_kernels,
                     *boost::unit_test::tolerance(1e-6)) {
  const Mesh mesh = cube(3);
  for (const double nu : {0., 0.45})
    for (const double damping : {0., 0.5}) {
      const Scene scene = with_top_moved({0, 0, 0}, nu);
      const MotionSettings settings =
          settings_of(Law::st_venant_kirchhoff, Element::q1, 1, std::nullopt, damping);
      BOOST_TEST(
          largest_stable_step(mesh, scene, settings) ==
          largest_stable_step(mesh, scene,
                              ExplicitSettings{.element = ExplicitElement::eight_points,
                                               .protocol = settings.protocol,
                                               .damping_ratio = damping}));
    }
}

// v = dt f/m after a step from a displaced state: each node of a tetrahedron has a
// quarter of its mass.
BOOST_AUTO_TEST_CASE(a_tetrahedron_gives_each_node_a_quarter_of_its_mass,
                     *boost::unit_test::tolerance(1e-12)) {
  const Mesh mesh = warped_cube(2, CellPattern::tetrahedron);
  std::vector<double> masses(mesh.nodes().size(), 0);
  for (std::size_t c = 0; c < mesh.cells().size(); ++c)
    for (const NodeIndex node : mesh.cells()[c])
      masses[node] += 1000 * mesh.cell_volumes()[c] / 4;
  const Scene scene{
      .material = of_poisson_ratio(0.3), .plates = {}, .gravity = Vector3::Zero()};
  const std::vector<Vector3> at_rest(masses.size(), Vector3::Zero());
  for (const Element element : moving) {
    const auto motion =
        motion_of(mesh, scene, settings_of(Law::hencky, element, 1, std::nullopt, 0));
    const dynamics::State moved{.displacements = random_at_nodes(mesh, 1e-3, 3),
                                .velocities = at_rest};
    const std::vector<Vector3> forces = motion->forces_at(moved);
    motion->restore(moved);
    const auto still = dynamics::support_motions(scene, 0);
    const double dt = 1e-4;
    motion->advance({.dt = dt,
                     .kick = dt,
                     .load_fraction = 0,
                     .motions_before = still,
                     .motions = still});
    const std::vector<Vector3> velocities = motion->state().velocities;
    for (std::size_t n = 0; n < masses.size(); ++n)
      for (int i = 0; i < 3; ++i)
        BOOST_TEST(masses[n] * velocities[n][i] == dt * forces[n][i]);
  }
}

// v += dt (g n/N - alpha v) and x += dt v, by the same steps for one number: the block
// falls without strain.
BOOST_AUTO_TEST_CASE(a_block_falls_freely_but_for_its_drag) {
  const Vector3 g(3, 0, -10);
  const Scene scene{.material = of_poisson_ratio(0.25), .plates = {}, .gravity = g};
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = cube(2, pattern);
    const double alpha = drag_rate(mesh, scene.material, 0.1);
    double x = 0, v = 0;
    for (int n = 1; n <= 100; ++n) {
      v += 0.001 * (n / 100. - alpha * v);
      x += 0.001 * v;
    }
    for (const Law law : laws)
      for (const Element element : moving) {
        const Solution end =
            run_dynamics(mesh, scene, settings_of(law, element, 0.1, 0.001, 0.1));
        BOOST_TEST((end.status == SolveStatus::ok), end.reason);
        for (const Vector3& u : end.displacements)
          BOOST_TEST((u - x * g).norm() < 1e-12 * x * g.norm(),
                     words(law) << ", " << words(element) << ", " << words(pattern));
      }
  }
}

// Slowly and with a drag the block is led through its equilibria: what it lags behind
// falls with the speed of the plate.
BOOST_AUTO_TEST_CASE(slow_motions_end_near_the_static_solution) {
  const double way = 0.05 * edge;
  const Scene scene = with_top_moved(way * Vector3(.5, 0, -1), 0.4);
  for (const CellPattern pattern : others) {
    const Mesh mesh = cube(2, pattern);
    for (const Law law : laws)
      for (const Element element : moving) {
        const bool is_looked_at =
            element == Element::q1_nodal || law == Law::hencky || law == Law::cauchy_born;
        if (!is_looked_at) continue;
        const Solution rest = solve(mesh, scene, {.law = law, .element = element});
        const auto lag = [&](double duration) {
          const Solution end = run_dynamics(
              mesh, scene, settings_of(law, element, duration, std::nullopt, 0.5));
          BOOST_TEST((end.status == SolveStatus::ok), end.reason);
          BOOST_TEST((end.lever_arms == rest.lever_arms));
          return farthest(end.displacements, rest.displacements) / way;
        };
        BOOST_TEST_CONTEXT(words(law)
                           << ", " << words(element) << ", " << words(pattern)) {
          const double in_one_second = lag(1), in_four_seconds = lag(4);
          BOOST_TEST(in_one_second < 0.05);
          BOOST_TEST(in_four_seconds == in_one_second / 4,
                     boost::test_tools::tolerance(0.2));
        }
      }
  }
}

// A plate that has come to rest does no work: kinetic and strain energy are then kept to
// the second order of the step. That of the masses is not without that of the forces.
BOOST_AUTO_TEST_CASE(energy_is_kept_without_drag_while_nothing_moves) {
  const Scene scene = with_top_moved(0.04 * edge * Vector3(.5, 0, -1), 0.3);
  for (const CellPattern pattern : others) {
    const Mesh mesh = cube(2, pattern);
    for (const Law law : laws) {
      const auto drift = [&](double dt) {
        MotionSettings settings = settings_of(law, Element::q1_nodal, 0.02, dt, 0);
        settings.protocol.integrator = Integrator::verlet;
        settings.protocol.load = {{.time = 0.004, .fraction = 1},
                                  {.time = 0.06, .fraction = 1}};
        double least = INFINITY, most = 0, kinetic = 0;
        const Solution end = run_dynamics(
            mesh, scene, settings,
            {.samples = 28, .sample = [&](const dynamics::Moment& moment) {
               if (moment.time < 0.0041) return;
               const double energy = moment.kinetic_energy + moment.strain_energy;
               least = std::min(least, energy);
               most = std::max(most, energy);
               kinetic = std::max(kinetic, moment.kinetic_energy);
             }});
        BOOST_TEST((end.status == SolveStatus::ok), end.reason);
        BOOST_TEST(kinetic > 0.1 * most);
        return (most - least) / most;
      };
      BOOST_TEST_CONTEXT(words(law) << ", " << words(pattern)) {
        const double coarse = drift(4e-4), fine = drift(2e-4);
        BOOST_TEST(coarse < 0.05);
        BOOST_TEST(fine == coarse / 4, boost::test_tools::tolerance(0.35));
      }
    }
  }
}

// 2 % below the limit the motion stays of the size of what is imposed, and 2 % above it
// it is found to be unstable.
BOOST_AUTO_TEST_CASE(they_are_stable_below_the_limit_and_diverged_above) {
  constexpr double squeeze = 1e-4;  // [m]
  for (const CellPattern pattern : others)
    for (const Law law : laws)
      for (const double nu : {0.25, 0.499}) {
        const Mesh mesh = cube(2, pattern);
        Scene scene = with_top_moved(squeeze * Vector3(.4, .3, -1), nu);
        scene.gravity = {.1, .2, .3};
        MotionSettings settings =
            settings_of(law, Element::q1_nodal, 1, std::nullopt, 0.05);
        const double limit = largest_stable_step(mesh, scene, settings);
        BOOST_TEST_CONTEXT(words(law) << ", " << words(pattern) << ", nu " << nu) {
          dynamics::expect_stability_up_to(limit, settings.protocol.integrator,
                                           2 * squeeze,
                                           [&](const dynamics::Protocol& protocol) {
                                             settings.protocol = protocol;
                                             return run_dynamics(mesh, scene, settings);
                                           });
        }
      }
}

BOOST_AUTO_TEST_CASE(any_number_of_threads_makes_the_same_bits) {
  const Mesh mesh = cube(3, CellPattern::mixed);
  const Scene scene = with_top_moved({0, 0, -0.05 * edge}, 0.45);
  MotionSettings settings =
      settings_of(Law::hencky, Element::q1_nodal, 0.1, std::nullopt, 0.1);
  const Solution one = run_dynamics(mesh, scene, settings);
  settings.threads = 2;
  const Solution two = run_dynamics(mesh, scene, settings);
  BOOST_TEST(farthest(one.displacements, two.displacements) == 0);
  BOOST_TEST(farthest(one.reactions, two.reactions) == 0);
}

BOOST_AUTO_TEST_CASE(what_they_do_not_cover_is_refused_with_a_reason) {
  const Mesh mesh = cube(2);
  const auto reason_of = [&](const Scene& scene, const MotionSettings& settings) {
    const Solution solution = run_dynamics(mesh, scene, settings);
    BOOST_TEST((solution.status == SolveStatus::refused));
    return solution.reason;
  };
  const Scene scene = with_top_moved({0, 0, 0}, -0.3);
  BOOST_TEST(reason_of(scene, settings_of(Law::hencky, Element::q2, 1, {}, 0)) ==
             "elements in motion move the mesh's nodes; q2 has more of them");
  MotionSettings implicit = settings_of(Law::hencky, Element::q1, 1, {}, 0);
  implicit.protocol.integrator = Integrator::implicit_euler;
  BOOST_TEST(reason_of(scene, implicit).find("step explicitly") != std::string::npos);
  MotionSettings baudet = settings_of(Law::cauchy_born, Element::q1, 1, {}, 0);
  baudet.elements.lattice.springs = Springs::baudet;
  BOOST_TEST(reason_of(scene, baudet).find("-0.25") != std::string::npos);
  Scene turned = with_top_moved({0, 0, 0});
  turned.plates.back().motion.angle = 1.1 * std::numbers::pi;
  BOOST_TEST(reason_of(turned, settings_of(Law::hooke, Element::q1, 1, {}, 0))
                 .find("half a turn") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
