#include "dynamics/marching/stable_step.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mss/motion/dynamics.hpp"
#include "tests/dynamics/marching/beside_limit.hpp"
#include "tests/mss/blocks.hpp"
#include "tests/referee/figures.hpp"

using namespace springcheck;
using namespace springcheck::mss;
using dynamics::Integrator;

BOOST_AUTO_TEST_SUITE(stable_step_test)

namespace {

Material tissue(double nu) {
  return {.young_modulus = 1e4, .poisson_ratio = nu, .density = 1000};
}

/// Largest stable step [s] of a free block of n^3 cells of 5 mm.
double limit_of_free_block(int n, SpringModel model, double nu, double damping_ratio,
                           StrainMeasure measure = StrainMeasure::engineering) {
  const Mesh mesh = cube(n, 0.005);
  const Network network = build_network(mesh, tissue(nu), springs_in(measure, model));
  return largest_stable_step(network, damping_ratio,
                             std::vector<bool>(3 * mesh.nodes().size(), true));
}

/// Adds a spring, and a cell of two nodes that has it: its tangent is the cell's.
void add_spring(Network& network, const Spring& spring) {
  network.springs.push_back(spring);
  const Vector3 rest =
      network.rest_positions[spring.b] - network.rest_positions[spring.a];
  network.cells.add(std::array{spring.a, spring.b},
                    std::array<Vector3, 2>{Vector3::Zero(), Vector3::Zero()}, 1,
                    std::array{CellSpring{{0, 1}, spring.stiffness, rest}});
}

/// A unit mass on a wall by a spring of 9 N/m: omega = 3 rad/s.
Network oscillator() {
  Network network{.rest_positions = {Vector3(0, 0, 0), Vector3(1, 0, 0)},
                  .springs = {},
                  .cells = {},
                  .masses = {1e9, 1}};
  add_spring(network, {.a = 0, .b = 1, .stiffness = 9, .rest_length = 1});
  return network;
}

}  // namespace

// 2/omega, and with 4 - 2 dt c - dt^2 k = 0, c = 2 zeta sqrt(k) = 6 zeta (the wall's
// mass enters c by 1e-9): dt = (-c + sqrt(c^2 + 4 k))/k. The search stops at 1e-4.
BOOST_AUTO_TEST_CASE(single_oscillator_has_the_limit_of_the_textbook,
                     *boost::unit_test::tolerance(2e-4)) {
  const std::vector<bool> is_free{false, false, false, true, true, true};
  BOOST_TEST(largest_stable_step(oscillator(), 0, is_free) == 2. / 3);
  for (const double zeta : {0.05, 0.5, 1.}) {
    const double c = 6 * zeta;
    BOOST_TEST(largest_stable_step(oscillator(), zeta, is_free) ==
               (-c + std::sqrt(c * c + 36)) / 9);
  }
}

// Held along the stiffer spring, a mass swings along the softer one: omega is 3, then 2.
BOOST_AUTO_TEST_CASE(held_component_does_not_swing, *boost::unit_test::tolerance(2e-4)) {
  Network corner = oscillator();
  corner.rest_positions.emplace_back(1, 1, 0);
  add_spring(corner, {.a = 1, .b = 2, .stiffness = 4, .rest_length = 1});
  corner.masses.push_back(1e9);
  std::vector<bool> is_free(9, false);
  is_free[3] = is_free[4] = is_free[5] = true;
  BOOST_TEST(largest_stable_step(corner, 0, is_free) == 2. / 3);
  is_free[3] = false;
  BOOST_TEST(largest_stable_step(corner, 0, is_free) == 2. / 2);
}

// A free node between eight cells whose volumes push more than their springs hold: the
// tangent there is negative, dashpots or not.
BOOST_AUTO_TEST_CASE(what_does_not_swing_has_no_limit) {
  const Mesh mesh = cube(2, 0.005);
  std::vector<bool> is_free(3 * mesh.nodes().size(), false);
  is_free[3 * 13] = is_free[3 * 13 + 1] = is_free[3 * 13 + 2] = true;
  const auto limit = [&](double volume_modulus, double damping_ratio) {
    return largest_stable_step(
        build_network(mesh, tissue(0.25), custom({22, 6, 6}, volume_modulus)),
        damping_ratio, is_free);
  };
  for (const double damping_ratio : {0., 0.1}) {
    BOOST_TEST(std::isinf(limit(-1e6, damping_ratio)));
    BOOST_TEST(std::isfinite(limit(-1e3, damping_ratio)));
  }
}

// The referee's are eigenvalues, to all digits; the search stops at 1e-4.
BOOST_AUTO_TEST_CASE(free_block_has_the_limits_of_the_referee_s_eigenvalues,
                     *boost::unit_test::tolerance(2e-4)) {
  const auto expect = [](const char* name, SpringModel model, const char* nu,
                         const char* zeta) {
    BOOST_TEST(limit_of_free_block(10, model, std::stod(nu), std::stod(zeta)) ==
               referee::figure("steps", fmt::format("{} nu {} zeta {}", name, nu, zeta),
                               "step"));
  };
  for (const char* nu : {"0", "0.1", "0.25", "0.3", "0.4", "0.45", "0.49", "0.499"}) {
    expect("mss-cf", SpringModel::cf, nu, "0");
    expect("mss-nfd", SpringModel::nfd, nu, "0");
  }
  for (const char* nu : {"0", "0.25", "0.499"})
    expect("mss-baudet", SpringModel::baudet, nu, "0");
  for (const char* zeta : {"0.05", "0.2", "0.5", "1"})
    expect("mss-cf", SpringModel::cf, "0.25", zeta);
}

// At rest all strain measures have the same tangent. They differ in that motions of
// finite size probe it: 1e-6 is more than their curvature.
BOOST_AUTO_TEST_CASE(strain_measures_have_the_same_limit_at_rest,
                     *boost::unit_test::tolerance(1e-6)) {
  for (const SpringModel model : {SpringModel::cf, SpringModel::nfd, SpringModel::affine})
    for (const double nu : {0., 0.25, 0.45}) {
      const double engineering = limit_of_free_block(4, model, nu, 0);
      for (const StrainMeasure measure : all_measures)
        BOOST_TEST(limit_of_free_block(4, model, nu, 0, measure) == engineering);
    }
}

BOOST_AUTO_TEST_CASE(prescribed_components_never_shorten_the_step) {
  const Mesh mesh = cube(3, 0.005);
  const Network network =
      build_network(mesh, tissue(0.25), in_shear_modulus_form(SpringModel::cf));
  std::vector<bool> is_free(3 * mesh.nodes().size(), true);
  const double all_free = largest_stable_step(network, 0, is_free);
  for (const NodeIndex node : mesh.region("bottom").nodes) is_free[3 * node + 2] = false;
  const double sliding = largest_stable_step(network, 0, is_free);
  BOOST_TEST(sliding >= all_free * (1 - 1e-4));
  for (const NodeIndex node : mesh.region("bottom").nodes)
    is_free[3 * node] = is_free[3 * node + 1] = false;
  BOOST_TEST(largest_stable_step(network, 0, is_free) >= sliding * (1 - 1e-4));
}

// The real thing: 2 % below the limit the motion stays of the size of what is imposed,
// and 2 % above it is found to be unstable: with dashpots by the velocities that turn
// round from step to step, where the springs' nonlinearity holds the motion. Near the
// limit z = -1 - 3 (dt/limit - 1) at zeta = 1, its least: out of rounding the motion
// grows by 6 % a step, to its full size within 700 steps. Plate and gravity are oblique,
// to stir modes of every symmetry.
BOOST_AUTO_TEST_CASE(dynamics_is_stable_below_the_limit_and_diverged_above) {
  const Mesh mesh = cube(3, 0.005);
  constexpr double squeeze = 1e-4;  // [m]
  for (const auto& [name, model] : models)
    for (const double nu : {0., 0.25, 0.4, 0.499})
      for (const Integrator integrator :
           {Integrator::semi_implicit_euler, Integrator::verlet})
        for (const double damping : {0., 0.05, 0.2, 1.}) {
          const Scene scene{.material = tissue(nu),
                            .plates = {{"bottom", translation({0, 0, 0}), all_components},
                                       {"top", translation(squeeze * Vector3(.4, .3, -1)),
                                        all_components}},
                            .gravity = {1, 2, 3}};
          if (reason_to_refuse(mesh, scene.material, model)) continue;
          const Network network =
              build_network(mesh, scene.material, in_shear_modulus_form(model));
          const double limit = largest_stable_step(
              network, damping,
              free_components(mesh, prescribed_components(mesh, scene)));
          BOOST_TEST_CONTEXT(name << ", nu " << nu << ", zeta " << damping << ", "
                                  << static_cast<int>(integrator)) {
            dynamics::expect_stability_up_to(
                limit, integrator, 2 * squeeze, [&](const dynamics::Protocol& protocol) {
                  return run_dynamics(mesh, scene, network,
                                      {.protocol = protocol, .damping_ratio = damping});
                });
          }
        }
}

// The limits are followed from the limit at rest on, state by state as a march looks at
// them, within the 1 % that is claimed of a search from nothing.
BOOST_AUTO_TEST_CASE(limits_found_near_are_those_found_from_nothing,
                     *boost::unit_test::tolerance(0.01)) {
  const Mesh mesh = cube(4, 0.005);
  const Scene scene{.material = tissue(.49), .plates = {}, .gravity = Vector3::Zero()};
  for (const auto& [name, model] : {NamedModel{"mss-cf", SpringModel::cf},
                                    NamedModel{"mss-affine", SpringModel::affine}})
    for (const double damping : {0., 0.05, 1.}) {
      const Network network =
          build_network(mesh, scene.material, in_shear_modulus_form(model));
      const DynamicsSettings settings{
          .protocol = {.integrator = Integrator::semi_implicit_euler,
                       .duration = 1,
                       .time_step = std::nullopt,
                       .force_time_step = false},
          .damping_ratio = damping};
      const auto motion = motion_of(mesh, scene, network, settings);
      const std::size_t nodes = mesh.nodes().size();
      dynamics::State state{.displacements = std::vector<Vector3>(nodes, Vector3::Zero()),
                            .velocities = std::vector<Vector3>(nodes, Vector3::Zero())};
      const auto limit = [&](const dynamics::StableStep* near) {
        return dynamics::largest_stable_step(
            {.forces = {},
             .state = state,
             .masses = network.masses,
             .is_free = std::vector<bool>(3 * nodes, true),
             .amplitude = dynamics::probe * 0.005,
             .has_dashpots = damping > 0},
            *motion, Precision::double_precision, state, Integrator::semi_implicit_euler,
            near);
      };
      dynamics::StableStep found = limit(nullptr);
      const double at_rest = found.limit;
      const int from_nothing = found.force_evaluations;
      for (int look = 1; look <= 20; ++look) {
        for (std::size_t n = 0; n < nodes; ++n) {
          const Vector3& x = mesh.nodes()[n];
          state.displacements[n] =
              look / 20. *
              Vector3(.2 * x.x() + 4 * x.y() * x.z(), -.2 * x.y(), -.3 * x.z());
        }
        found = limit(&found);
        BOOST_TEST_CONTEXT(name << ", zeta " << damping << ", look " << look) {
          BOOST_TEST(found.limit == limit(nullptr).limit);
          if (look > 3) BOOST_TEST(found.force_evaluations < from_nothing / 2);
        }
      }
      BOOST_TEST(std::abs(found.limit / at_rest - 1) > 0.03);  // there was a way to go
    }
}

BOOST_AUTO_TEST_SUITE_END()
