#include "mss/motion/dynamics.hpp"

#include <boost/test/unit_test.hpp>

#include "mss/statics/equilibrium.hpp"
#include "tests/mss/blocks.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(dynamics_test)

namespace {

constexpr Material tissue{.young_modulus = 1e4, .poisson_ratio = 0.25, .density = 1000};

/// Semi-implicit Euler; no step: of its own choice.
DynamicsSettings steps(double duration, std::optional<double> time_step,
                       double damping_ratio) {
  return {.protocol = {.integrator = dynamics::Integrator::semi_implicit_euler,
                       .duration = duration,
                       .time_step = time_step,
                       .force_time_step = false},
          .damping_ratio = damping_ratio};
}

}  // namespace

// v += dt g n/N and x += dt v over N steps, summed by hand: g dt^2 (N+1)(N+2)/6. The
// block falls without strain, so the tolerance is round-off of N additions.
BOOST_AUTO_TEST_CASE(block_without_plates_falls_freely) {
  const Mesh mesh = cube(2, 0.005);
  const Vector3 g(3, 0, -10);
  const Scene scene{.material = tissue, .plates = {}, .gravity = g};
  const Network network =
      build_network(mesh, tissue, in_shear_modulus_form(SpringModel::cf));
  const Solution solution = run_dynamics(mesh, scene, network, steps(0.1, 0.001, 0.1));
  BOOST_TEST((solution.status == SolveStatus::ok));
  BOOST_TEST(solution.steps == 100);
  const Vector3 fallen = g * 0.001 * 0.001 * 101 * 102 / 6;
  for (const Vector3& u : solution.displacements) BOOST_TEST((u - fallen).norm() < 1e-14);
  BOOST_TEST(norm(solution.reactions) == 0);
}

// Slowly and with dashpots the block is led through its equilibria. Plates moving at
// v = 0.75 mm/s still drag: in 1 s the state lags by about 1e-4 of the way, in 4 s by a
// quarter of that.
BOOST_AUTO_TEST_CASE(slow_damped_dynamics_ends_near_the_equilibrium) {
  const Mesh mesh = cube(3, 0.005);
  const double way = 0.05 * 0.015;
  const Scene scene{.material = tissue,
                    .plates = {{"bottom", translation({0, 0, 0}), all_components},
                               {"top", translation({0, 0, -way}), all_components}},
                    .gravity = Vector3::Zero()};
  const Network network =
      build_network(mesh, tissue, in_shear_modulus_form(SpringModel::cf));
  const Solution rest = find_equilibrium(mesh, scene, network);
  const auto lag = [&](double duration) {
    const Solution end =
        run_dynamics(mesh, scene, network, steps(duration, std::nullopt, 0.2));
    double squares = 0;
    for (std::size_t n = 0; n < end.displacements.size(); ++n)
      squares += (end.displacements[n] - rest.displacements[n]).squaredNorm();
    return std::sqrt(squares) / way;
  };
  const double in_one_second = lag(1), in_four_seconds = lag(4);
  BOOST_TEST(in_one_second < 1e-3);
  BOOST_TEST(in_four_seconds == in_one_second / 4, boost::test_tools::tolerance(0.1));
}

// A block between sliding plates, and one on a sliding plate under a growing traction. In
// 4 s the state lags by 2e-4 of the way (measured; 8e-4 in 1 s).
BOOST_AUTO_TEST_CASE(slow_dynamics_on_sliding_plates_ends_near_the_equilibrium) {
  const Mesh mesh = cube(3, 0.005);
  const Held only_z{false, false, true};
  const std::vector<Pin> pins{{.point = {0, 0, 0}, .held = {true, true, false}},
                              {.point = {0.015, 0, 0}, .held = {false, true, false}}};
  const Plate lower{"bottom", translation({0, 0, 0}), only_z};
  const Scene scenes[] = {
      {.material = tissue,
       .plates = {lower, {"top", translation({0, 0, 7.5e-4}), only_z}},
       .pins = pins,
       .gravity = Vector3::Zero()},
      {.material = tissue,
       .plates = {lower},
       .pins = pins,
       .tractions = {{"top", {0, 0, 500}}},
       .gravity = Vector3::Zero()}};
  for (const Scene& scene : scenes) {
    const Network network =
        build_network(mesh, tissue, in_shear_modulus_form(SpringModel::cf));
    const Solution rest = find_equilibrium(mesh, scene, network),
                   end = run_dynamics(mesh, scene, network, steps(4, std::nullopt, 0.2));
    BOOST_TEST((end.status == SolveStatus::ok), end.reason);
    for (std::size_t n = 0; n < rest.displacements.size(); ++n) {
      BOOST_TEST((end.displacements[n] - rest.displacements[n]).norm() < 5e-4 * 7.5e-4);
      BOOST_TEST((end.reactions[n] - rest.reactions[n]).norm() <
                 1e-2 * norm(rest.reactions));
    }
  }
}

BOOST_AUTO_TEST_CASE(step_above_the_limit_is_refused_unless_forced) {
  const Mesh mesh = cube(2, 0.005);
  const Scene scene{.material = tissue,
                    .plates = {{"bottom", translation(Vector3::Zero()), all_components}},
                    .gravity = Vector3::Zero()};
  const Network network =
      build_network(mesh, tissue, in_shear_modulus_form(SpringModel::cf));
  DynamicsSettings settings = steps(0.1, 0.01, 0);
  const Solution refused = run_dynamics(mesh, scene, network, settings);
  BOOST_TEST((refused.status == SolveStatus::refused));
  BOOST_TEST(refused.steps == 0);
  BOOST_TEST(refused.displacements.empty());
  BOOST_TEST(*refused.dt == 0.01);
  BOOST_TEST(*refused.dt_limit < 0.01);
  BOOST_TEST(refused.reason.find("above the stability limit") != std::string::npos);

  settings.protocol.time_step.reset();
  const Solution automatic = run_dynamics(mesh, scene, network, settings);
  BOOST_TEST((automatic.status == SolveStatus::ok));
  BOOST_TEST(*automatic.dt <= *automatic.dt_limit);
  BOOST_TEST(*automatic.dt * automatic.steps == settings.protocol.duration,
             boost::test_tools::tolerance(1e-14));  // a whole number of steps
}

// A cube whose boundary is held, about its one free node: no eigenvalue of its tangent is
// positive, and a step of the whole duration would be none.
BOOST_AUTO_TEST_CASE(open_step_is_refused_where_nothing_swings) {
  const Mesh mesh = cube(2, 0.005);
  Scene scene{.material = tissue, .plates = {}, .gravity = Vector3::Zero()};
  scene.boundary_gradient = 0.1 * Eigen::Matrix3d::Identity();
  const Network network = build_network(mesh, tissue, custom({22, 6, 6}, -1e6));
  DynamicsSettings settings = steps(0.1, std::nullopt, 0);
  const Solution open = run_dynamics(mesh, scene, network, settings);
  BOOST_TEST((open.status == SolveStatus::refused));
  BOOST_TEST(open.reason.find("no swing") != std::string::npos);
  BOOST_TEST(!open.dt.has_value());
  BOOST_TEST(!open.dt_limit.has_value());
  settings.protocol.time_step = 0.001;
  BOOST_TEST(
      (run_dynamics(mesh, scene, network, settings).status != SolveStatus::refused));
}

BOOST_AUTO_TEST_SUITE_END()
