#define BOOST_TEST_MODULE tissue_dynamics
#include "mss/tissue/tissue_dynamics.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "blocks.hpp"
#include "mss/tissue/quasi_static.hpp"
#include "tissue/maxwell_fit.hpp"

using namespace springcheck;
using namespace springcheck::mss;
using dynamics::Integrator;

namespace {

constexpr double h = 0.005;  // [m]
constexpr Material any_material{.young_modulus = 1, .poisson_ratio = 0, .density = 1000};

tissue::Solid spleen(double nu) {
  return {tissue::fit_maxwell_model(tissue::law_of_organ("spleen")).model,
          tissue::bulk_ratio_of(nu)};
}

Scene in_simple_shear(double strain) {
  Matrix3 gradient = Matrix3::Zero();
  gradient(0, 2) = strain;
  return {.material = any_material,
          .plates = {},
          .boundary_gradient = gradient,
          .gravity = Vector3::Zero()};
}

Scene between_glued_plates(const Vector3& way) {
  return {.material = any_material,
          .plates = {{"bottom", translation(Vector3::Zero()), all_components},
                     {"top", translation(way), all_components}},
          .gravity = Vector3::Zero()};
}

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
  const TissueBody body = build_tissue_body(mesh, spleen(0.45), 1000);
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
  const TissueBody body = build_tissue_body(mesh, spleen(0.45), 1000);
  const Scene scene = between_glued_plates({1.5 * h, 0, 0});
  const double duration = 0.5 / 0.133;
  const Solution moved = run_tissue_dynamics(mesh, scene, body, protocol(duration));
  const Solution balanced =
      find_quasi_static(mesh, scene, body, {.duration = duration, .steps = 100});
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
  const TissueBody body = build_tissue_body(mesh, spleen(0.499), 1000);
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
