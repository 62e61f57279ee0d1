#include "mss/tissue/tissue_dynamics.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mss/tissue/quasi_static.hpp"
#include "tests/mss/tissue/tissue_scenes.hpp"

using namespace springcheck;
using namespace springcheck::mss;
using dynamics::Integrator;

BOOST_AUTO_TEST_SUITE(tissue_dynamics_test)

namespace {

dynamics::Protocol protocol(double duration, double step_ratio = 0.9,
                            Integrator integrator = Integrator::semi_implicit_euler) {
  return {.integrator = integrator,
          .duration = duration,
          .time_step = std::nullopt,
          .step_ratio = step_ratio,
          .force_time_step = false};
}

Vector3 force_on_top(const Mesh& mesh, const Solution& solution) {
  Vector3 force = Vector3::Zero();
  for (const NodeIndex n : mesh.region("top").nodes) force += solution.reactions[n];
  return force;
}

}  // namespace

// The node inside starts from rest and is soon carried along; steps are a thousandth of
// the time, and the wave's way through the body a hundredth: half a percent.
BOOST_AUTO_TEST_CASE(a_sheared_body_has_the_branches_stress) {
  const Mesh mesh = cube(2, h);
  const TissueBody body = build_tissue_body(mesh, solid_of("spleen", 0.45), 1000);
  for (const Integrator integrator :
       {Integrator::semi_implicit_euler, Integrator::verlet}) {
    const Solution solution = run_tissue_dynamics(mesh, in_simple_shear(0.5), body,
                                                  protocol(0.5 / 0.67, 0.9, integrator));
    BOOST_TEST((solution.status == SolveStatus::ok), solution.reason);
    double stress = 0;
    for (std::size_t n = 0; n < mesh.nodes().size(); ++n)
      stress += solution.reactions[n].x() * mesh.nodes()[n].z() / mesh.volume();
    BOOST_TEST(stress == tissue::constant_rate_stress(body.solid.shear, 0.5, 0.67),
               boost::test_tools::tolerance(0.005));
    BOOST_TEST(solution.kinetic_energy.value() < 1e-3 * solution.strain_energy);
  }
}

// Slowly sheared between glued plates: inertia is a thousandth of the force.
BOOST_AUTO_TEST_CASE(slow_motion_goes_through_equilibria) {
  const Mesh mesh = cube(3, h);
  const TissueBody body = build_tissue_body(mesh, solid_of("spleen", 0.45), 1000);
  const Scene scene = between_glued_plates({1.5 * h, 0, 0});
  const double duration = 0.5 / 0.133;
  const Solution moved = run_tissue_dynamics(mesh, scene, body, protocol(duration));
  const Solution balanced = find_quasi_static(
      mesh, scene, body, {.load = dynamics::ramp(duration), .steps = 100});
  BOOST_TEST_REQUIRE((moved.status == SolveStatus::ok), moved.reason);
  BOOST_TEST_REQUIRE((balanced.status == SolveStatus::ok), balanced.reason);
  const Vector3 force = force_on_top(mesh, balanced);
  BOOST_TEST((force_on_top(mesh, moved) - force).norm() < 0.005 * force.norm());
  BOOST_TEST(moved.strain_energy == balanced.strain_energy,
             boost::test_tools::tolerance(0.005));
}

// Above the limit a sheared body blows up, below it does not.
BOOST_AUTO_TEST_CASE(the_limit_is_where_steps_become_unstable) {
  const Mesh mesh = cube(2, h);
  const TissueBody body = build_tissue_body(mesh, solid_of("spleen", 0.499), 1000);
  const Scene scene = between_glued_plates({0.02 * h, 0, 0});
  const auto status = [&](double step_ratio) {
    return run_tissue_dynamics(mesh, scene, body, protocol(0.2, step_ratio)).status;
  };
  BOOST_TEST((status(0.97) == SolveStatus::ok));
  BOOST_TEST((status(1.05) == SolveStatus::diverged));
}

BOOST_AUTO_TEST_CASE(what_tissue_does_not_do_is_refused) {
  BOOST_TEST(!reason_to_refuse_tissue(protocol(1), {}));
  BOOST_TEST(reason_to_refuse_tissue(protocol(1, 0.9, Integrator::implicit_euler), {})
                 .value()
                 .starts_with("tissue steps explicitly"));
  const dynamics::Observers observers{.checkpoint = [](const dynamics::Checkpoint&) {}};
  BOOST_TEST(reason_to_refuse_tissue(protocol(1), observers)
                 .value()
                 .starts_with("tissue has no checkpoints"));
}

BOOST_AUTO_TEST_SUITE_END()
