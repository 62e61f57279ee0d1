#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>

#include "mss/forces/forces.hpp"
#include "tests/mss/spring_runs.hpp"

using namespace springcheck;
using namespace springcheck::mss;
using dynamics::Integrator;

BOOST_AUTO_TEST_SUITE(explicit_limit_test)

namespace {

constexpr double h = 0.005;  // [m]

/// Largest dt with |1 + dt Gamma| <= 1 for all rates Gamma of the network at rest: of M
/// v' = -K u - C v by dense eigenvalues, and by its matrices from differences of forces.
double limit_by_dense_rates(const Network& network, double zeta,
                            const std::vector<bool>& is_free) {
  std::vector<std::size_t> components;
  for (std::size_t i = 0; i < is_free.size(); ++i)
    if (is_free[i]) components.push_back(i);
  const auto count = static_cast<Eigen::Index>(components.size());
  Eigen::MatrixXd rates = Eigen::MatrixXd::Zero(2 * count, 2 * count);
  rates.topRightCorner(count, count).setIdentity();
  const std::vector<Vector3>& rest = network.rest_positions;
  const double probe = 1e-5 * h, speed = 1e-3;
  for (Eigen::Index j = 0; j < count; ++j) {
    const std::size_t node = components[static_cast<std::size_t>(j)] / 3;
    const auto axis =
        static_cast<Eigen::Index>(components[static_cast<std::size_t>(j)] % 3);
    std::vector<Vector3> ahead(rest.size()), behind(rest.size()),
        drag(rest.size(), Vector3::Zero()), x = rest, v(rest.size(), Vector3::Zero());
    x[node][axis] += probe;
    nodal_forces(network, x, ahead);
    x[node][axis] -= 2 * probe;
    nodal_forces(network, x, behind);
    v[node][axis] = speed;
    add_dashpot_forces(network, zeta, rest, v, drag);
    for (Eigen::Index i = 0; i < count; ++i) {
      const std::size_t to = components[static_cast<std::size_t>(i)];
      const auto k = static_cast<Eigen::Index>(to % 3);
      const double mass = network.masses[to / 3];
      rates(count + i, j) = (ahead[to / 3][k] - behind[to / 3][k]) / (2 * probe * mass);
      rates(count + i, count + j) = drag[to / 3][k] / (speed * mass);
    }
  }
  double limit = std::numeric_limits<double>::infinity();
  for (const std::complex<double>& rate : rates.eigenvalues())
    if (std::abs(rate) > 1e-3)
      limit = std::min(limit, -2 * rate.real() / std::norm(rate));
  return limit;
}

/// A body that stands on a plate.
Scene standing(double nu) {
  Scene scene = between_plates(tissue_of(nu), Vector3::Zero());
  scene.plates.pop_back();
  return scene;
}

}  // namespace

// The limit is on the safe side where damping and stiffness do not share their modes, and
// by no more than a fifth (measured: 3 to 13 %). The tolerance is 1e-3, as both are found
// by differences of forces.
BOOST_AUTO_TEST_CASE(the_limit_is_at_most_that_of_all_rates_and_close_to_it) {
  for (const auto& [name, model] : models)
    for (const double nu : {0., .25, .4, .499})
      for (const auto& [cells, zeta] :
           {std::pair(2, 0.05), {3, 0.05}, {3, 0.2}, {3, 1.}}) {
        const Mesh mesh = cube(cells, h);
        const Scene scene =
            cells == 2 ? between_plates(tissue_of(nu), Vector3::Zero()) : standing(nu);
        if (reason_to_refuse(mesh, scene.material, model)) continue;
        const Network network =
            build_network(mesh, scene.material, in_shear_modulus_form(model));
        const auto is_free = free_components(mesh, prescribed_components(mesh, scene));
        const double exact = limit_by_dense_rates(network, zeta, is_free),
                     found = largest_stable_step(network, zeta, is_free,
                                                 Integrator::explicit_euler);
        BOOST_TEST(found < 1.001 * exact, name << ", nu " << nu << ", zeta " << zeta);
        BOOST_TEST(found > 0.8 * exact, name << ", nu " << nu << ", zeta " << zeta);
      }
}

// The affine springs of mss-affine have dashpots on the cells' edges only, which leave
// motions that swing undamped.
BOOST_AUTO_TEST_CASE(no_step_is_stable_where_a_motion_is_not_damped) {
  const Mesh mesh = cube(2, h);
  const Scene scene = between_plates(tissue_of(.25), Vector3::Zero());
  const Network network =
      build_network(mesh, scene.material, in_shear_modulus_form(SpringModel::affine));
  const auto is_free = free_components(mesh, prescribed_components(mesh, scene));
  for (const double zeta : {0., 0.05, 1.})
    BOOST_TEST(largest_stable_step(network, zeta, is_free, Integrator::explicit_euler) ==
               0);
  const Solution open =
      run_dynamics(mesh, scene, network,
                   settings_of(Integrator::explicit_euler, 1, std::nullopt, .05));
  BOOST_TEST((open.status == SolveStatus::refused));
  BOOST_TEST(open.reason.find("stable with no step") != std::string::npos, open.reason);
}

// Two thousand steps just below the limit do not grow; far above it they do.
BOOST_AUTO_TEST_CASE(explicit_euler_is_stable_below_its_limit) {
  const Mesh mesh = cube(3, h);
  const std::size_t nodes = mesh.nodes().size();
  for (const double nu : {0., .25, .4}) {
    const Scene scene = standing(nu);
    const Network network =
        build_network(mesh, scene.material, in_shear_modulus_form(SpringModel::cf));
    const auto is_free = free_components(mesh, prescribed_components(mesh, scene));
    for (const double zeta : {0.05, 0.5}) {
      const double limit =
          largest_stable_step(network, zeta, is_free, Integrator::explicit_euler);
      const auto growth_after = [&](double dt) {
        const auto motion =
            motion_of(mesh, scene, network,
                      settings_of(Integrator::explicit_euler, 1, std::nullopt, zeta));
        motion->restore({.displacements = random_field(nodes, 1e-4 * h, 1),
                         .velocities = std::vector<Vector3>(nodes, Vector3::Zero())});
        let_go(*motion, scene, Integrator::explicit_euler, dt, 2000);
        return norm(motion->state().displacements) /
               norm(random_field(nodes, 1e-4 * h, 1));
      };
      BOOST_TEST_CONTEXT("nu " << nu << ", zeta " << zeta) {
        BOOST_TEST(growth_after(0.98 * limit) < 1);
        BOOST_TEST(!(growth_after(1.6 * limit) < 10));
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
