#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mss/forces/forces.hpp"
#include "mss/statics/equilibrium.hpp"
#include "tests/mss/spring_runs.hpp"

using namespace springcheck;
using namespace springcheck::mss;
using dynamics::Integrator;

BOOST_AUTO_TEST_SUITE(implicit_motion_test)

namespace {

constexpr double h = 0.005;  // [m]

/// Eight cells whose surface is held, about one node that is free: k and c are the same
/// along all axes, and motions along an axis stay on it.
struct FreeNode {
  static constexpr NodeIndex node = 13;
  Mesh mesh = cube(2, h);
  Scene scene = held();
  Network network =
      build_network(mesh, scene.material, in_shear_modulus_form(SpringModel::cf));

  static Scene held() {
    Scene scene = in_free_space(tissue_of(0.25));
    scene.boundary_gradient = Eigen::Matrix3d::Zero();
    return scene;
  }

  /// Pull on the node along x, at u along x and moving at v [N].
  [[nodiscard]] double force(double u, double v, double zeta) const {
    std::vector<Vector3> x = network.rest_positions, forces(x.size()),
                         velocities(x.size(), Vector3::Zero());
    x[node].x() += u;
    velocities[node].x() = v;
    nodal_forces(network, x, forces);
    add_dashpot_forces(network, zeta, x, velocities, forces);
    return forces[node].x();
  }
};

}  // namespace

// u_n+1 = u_n + dt v_n+1, v_n+1 = v_n + dt f(u_n+1, v_n+1)/m, solved by bisection; and
// for small motions the amplification 1/(1 - dt Gamma) of Eq. 2.35 (Golec 2018),
// |Gamma|^2 = k/m and -2 Re Gamma = c/m. Springs of length h are linear to (u/h)^2 = 1e-6
// there, and residuals are 1e-10 of the forces.
BOOST_AUTO_TEST_CASE(a_body_of_one_free_node_follows_the_scalar_recursion) {
  const FreeNode body;
  const double mass = body.network.masses[FreeNode::node];
  for (const double zeta : {0., 0.3})
    for (const double dt : {1e-4, 1e-3, 1e-1}) {
      const auto motion =
          motion_of(body.mesh, body.scene, body.network,
                    settings_of(Integrator::implicit_euler, 1, std::nullopt, zeta));
      const double start = 1e-3 * h;
      dynamics::State state = motion->state();
      state.displacements[FreeNode::node].x() = start;
      motion->restore(state);
      let_go(*motion, body.scene, Integrator::implicit_euler, dt, 10);
      const double found = motion->state().displacements[FreeNode::node].x();

      double u = start, v = 0;
      for (int n = 0; n < 10; ++n) {
        double low = -10 * start / dt, high = -low;  // of v_n+1
        for (int i = 0; i < 200; ++i) {
          const double middle = (low + high) / 2;
          const double excess =
              mass * (middle - v) - dt * body.force(u + dt * middle, middle, zeta);
          (excess > 0 ? high : low) = middle;
        }
        v = (low + high) / 2;
        u += dt * v;
      }
      BOOST_TEST(std::abs(found - u) < 1e-9 * start);

      const double k = -body.force(start, 0, 0) / start,
                   c = -body.force(0, 1e-3, zeta) / 1e-3;
      Eigen::Matrix2d step;  // of (u, v), implicit
      step << 1, -dt, dt * k / mass, 1 + dt * c / mass;
      Eigen::Vector2d linear(start, 0);
      for (int n = 0; n < 10; ++n) linear = step.inverse() * linear;
      BOOST_TEST(std::abs(found - linear[0]) < 2e-5 * start);
    }
}

// Twenty times the limit of explicit steps, and the motion dies away: the slowest mode
// here, of some 30 rad/s, by 1/(1 + i omega dt) a step.
BOOST_AUTO_TEST_CASE(steps_far_above_the_explicit_limit_are_stable) {
  const Mesh mesh = cube(3, h);
  const Scene scene = between_plates(tissue_of(0.4), Vector3::Zero());
  const Network network =
      build_network(mesh, scene.material, in_shear_modulus_form(SpringModel::cf));
  const double limit = largest_stable_step(
      network, 0, free_components(mesh, prescribed_components(mesh, scene)));
  for (const double zeta : {0., 0.2}) {
    const auto motion =
        motion_of(mesh, scene, network,
                  settings_of(Integrator::implicit_euler, 1, std::nullopt, zeta));
    dynamics::State start = motion->state();
    const auto is_free = free_components(mesh, prescribed_components(mesh, scene));
    const std::vector<Vector3> noise = random_field(mesh.nodes().size(), 0.05 * h, 1);
    for (std::size_t n = 0; n < noise.size(); ++n)
      for (int i = 0; i < 3; ++i)
        if (is_free[3 * n + static_cast<std::size_t>(i)])
          start.displacements[n][i] = noise[n][i];
    motion->restore(start);
    let_go(*motion, scene, Integrator::implicit_euler, 20 * limit, 50);
    BOOST_TEST(norm(motion->state().displacements) < 1e-6 * norm(start.displacements));
  }
}

// Ten steps of a tenth of a second: far from the explicit limit of 1 ms, and the state
// lags by what dashpots and inertia hold back, as in many small steps.
BOOST_AUTO_TEST_CASE(large_deformations_in_few_steps_end_near_the_equilibrium) {
  const Mesh mesh = cube(3, h);
  const Scene scene = between_plates(tissue_of(0.4), {0, 0, -0.1 * 3 * h});
  const Network network =
      build_network(mesh, scene.material, in_shear_modulus_form(SpringModel::cf));
  const Solution rest = find_equilibrium(mesh, scene, network),
                 end = run_dynamics(mesh, scene, network,
                                    settings_of(Integrator::implicit_euler, 1, 0.1, 0.2));
  BOOST_TEST((end.status == SolveStatus::ok), end.reason);
  BOOST_TEST(end.steps == 10);
  BOOST_TEST(!end.dt_limit.has_value());
  double largest = 0;
  for (std::size_t n = 0; n < rest.displacements.size(); ++n)
    largest = std::max(largest, (end.displacements[n] - rest.displacements[n]).norm());
  BOOST_TEST(largest > 0);
  BOOST_TEST(largest < 2e-3 * 0.1 * 3 * h);
}

// A metre from the origin positions resolve 2e-16 m: steps of a body under homogeneous
// strains of 1e-5, in equilibrium but for that, end where rounding ends all progress,
// often with the first trial. One that did not bring the velocities nearer to the
// equation's solution is not kept: its residual is at most that of no change of velocity.
BOOST_AUTO_TEST_CASE(round_off_does_not_lead_away_from_the_solution) {
  const Mesh near = cube(4, h);
  std::vector<Vector3> away = near.nodes();
  for (Vector3& x : away) x += Vector3(1, 1, 1);
  const Mesh mesh("away", std::move(away), near.cells(), {});
  constexpr double dt = 0.1;
  for (int i = 1; i <= 20; ++i) {
    Scene scene = in_free_space(tissue_of(.25));
    Eigen::Matrix3d gradient;
    gradient << -1, .3, .2, .3, .4, -.5, .2, -.5, .7;
    scene.boundary_gradient = i * 1e-6 * gradient;
    const Network network =
        build_network(mesh, scene.material, in_shear_modulus_form(SpringModel::cf));
    const auto is_free = free_components(mesh, prescribed_components(mesh, scene));
    const auto still = dynamics::support_motions(scene, 1);
    const std::size_t nodes = mesh.nodes().size();
    const auto residual = [&](const dynamics::State& state) {  // |dt f(u) - m v|
      std::vector<Vector3> forces(nodes);
      nodal_forces(network, sum(mesh.nodes(), state.displacements), forces);
      double square = 0;
      for (std::size_t n = 0; n < nodes; ++n)
        if (is_free[3 * n])
          square +=
              (dt * forces[n] - network.masses[n] * state.velocities[n]).squaredNorm();
      return std::sqrt(square);
    };
    const auto motion =
        motion_of(mesh, scene, network,
                  settings_of(Integrator::implicit_euler, 1, std::nullopt, 0));
    dynamics::State start = motion->state();
    for (std::size_t n = 0; n < nodes; ++n)
      start.displacements[n] = *scene.boundary_gradient * mesh.nodes()[n];
    motion->restore(start);
    motion->advance({.dt = dt,
                     .kick = dt,
                     .load_fraction = 1,
                     .motions_before = still,
                     .motions = still});
    BOOST_TEST(residual(motion->state()) <= residual(start), i);
  }
}

// Refused with the step at which it happened, where a residual that is no number compared
// as converged.
BOOST_AUTO_TEST_CASE(forces_that_are_no_numbers_are_not_taken_as_converged) {
  const FreeNode body;
  const auto settings = settings_of(Integrator::implicit_euler, 1, 0.1, 0);
  const auto motion = motion_of(body.mesh, body.scene, body.network, settings);
  dynamics::State state = motion->state();
  state.displacements[FreeNode::node].x() = std::numeric_limits<double>::quiet_NaN();
  motion->restore(state);
  BOOST_CHECK_THROW(let_go(*motion, body.scene, Integrator::implicit_euler, 0.1, 1),
                    std::runtime_error);
  const auto message = [&] {
    try {
      run_dynamics(
          body.mesh, body.scene, body.network, settings,
          {.from = dynamics::Checkpoint{
               .state = state, .step = 3, .time = 0.3, .dt = 0.1, .steps_left = 7}});
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("none");
  }();
  BOOST_TEST(message.find("step 4 (t = 0.4 s)") != std::string::npos, message);
  BOOST_TEST(message.find("no numbers") != std::string::npos, message);
}

BOOST_AUTO_TEST_SUITE_END()
