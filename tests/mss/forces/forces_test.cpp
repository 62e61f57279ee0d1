#include "mss/forces/forces.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "tests/mss/blocks.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(forces_test)

namespace {

/// 2^3 cells of edge 2 m (so that no volume is 1) and E = 1 Pa: forces and energies are
/// of the order of 1.
Network soft_block(SpringModel model, double nu) {
  return build_network(cube(2, 2),
                       {.young_modulus = 1, .poisson_ratio = nu, .density = 1},
                       in_shear_modulus_form(model));
}

/// Far from rest: every node moved by up to 0.3 of a cell.
std::vector<Vector3> deformed(const Network& network, unsigned seed) {
  return sum(network.rest_positions,
             random_field(network.rest_positions.size(), 0.6, seed));
}

std::vector<Vector3> forces_at(const Network& network, const std::vector<Vector3>& x) {
  // The forces are not zero: the function is to overwrite them.
  std::vector<Vector3> forces(x.size(), Vector3::Constant(1e9));
  nodal_forces(network, x, forces);
  return forces;
}

Vector3 moment(const std::vector<Vector3>& x, const std::vector<Vector3>& forces) {
  Vector3 all = Vector3::Zero();
  for (std::size_t n = 0; n < x.size(); ++n) all += x[n].cross(forces[n]);
  return all;
}

/// Two nodes a distance of 2 apart along x, of masses 1 and 3 kg, k = 12 N/m.
Network one_spring() {
  return {.rest_positions = {Vector3(0, 0, 0), Vector3(2, 0, 0)},
          .springs = {{.a = 0, .b = 1, .stiffness = 12, .rest_length = 2}},
          .cells = {},
          .masses = {1, 3}};
}

}  // namespace

// Central difference with a step of 1e-5 m: its truncation error is of the order of
// step^2 = 1e-10 of the third derivative, round-off 1e-15/1e-5 = 1e-10 of the energy.
BOOST_AUTO_TEST_CASE(forces_are_minus_the_gradient_of_the_energy) {
  constexpr double step = 1e-5;
  for (const auto& [name, model] : models)
    for (const double nu : {-0.2, 0., 0.25, 0.4, 0.49}) {
      const Network network = soft_block(model, nu);
      std::vector<Vector3> x = deformed(network, 1);
      const std::vector<Vector3> forces = forces_at(network, x);
      double squared_error = 0;
      for (std::size_t n = 0; n < x.size(); ++n)
        for (double& coordinate : x[n]) {
          const double here = coordinate;
          coordinate = here + step;
          const double ahead = strain_energy(network, x);
          coordinate = here - step;
          const double behind = strain_energy(network, x);
          coordinate = here;
          const double force = forces[n][&coordinate - x[n].data()];
          squared_error += std::pow(force + (ahead - behind) / (2 * step), 2);
        }
      BOOST_TEST(std::sqrt(squared_error) < 1e-8 * norm(forces), name << ", nu = " << nu);
    }
}

// Energy and force by hand are k/2 e^2 and k e with k = 12, e = 2, exact in binary.
BOOST_AUTO_TEST_CASE(stretched_spring_pulls_its_ends_together) {
  const Network network = one_spring();
  const std::vector<Vector3> x{Vector3(0, 0, 0), Vector3(0, 4, 0)};
  BOOST_TEST(strain_energy(network, x) == 24);
  const auto forces = forces_at(network, x);
  BOOST_TEST((forces[0] == Vector3(0, 24, 0)));
  BOOST_TEST((forces[1] == Vector3(0, -24, 0)));
}

// kappa/2 (V - V0)^2/V0 of one cell of V0 = 8 swollen by half in every direction, without
// its springs; exact in binary. kappa = 15/14 at nu = 0.4.
BOOST_AUTO_TEST_CASE(volume_change_costs_kappa_over_two_rest_volumes,
                     *boost::unit_test::tolerance(1e-14)) {
  Network network =
      build_network(cube(1, 2), {.young_modulus = 1, .poisson_ratio = 0.4, .density = 1},
                    in_shear_modulus_form(SpringModel::cf));
  network.springs.clear();
  std::vector<Vector3> x = network.rest_positions;
  for (Vector3& node : x) node *= 1.5;
  BOOST_TEST(strain_energy(network, x) == 15. / 14 / 2 * (27 - 8) * (27 - 8) / 8);
}

BOOST_AUTO_TEST_CASE(network_at_rest_is_free_of_force_and_energy) {
  for (const auto& [name, model] : models) {
    const Network network = soft_block(model, 0.4);
    BOOST_TEST(strain_energy(network, network.rest_positions) == 0, name);
    BOOST_TEST(norm(forces_at(network, network.rest_positions)) == 0, name);
  }
}

// The tolerance is round-off of sums of 27 forces at arms of about 4.
BOOST_AUTO_TEST_CASE(forces_and_their_moments_add_up_to_zero) {
  for (const auto& [name, model] : models)
    for (const double nu : {-0.2, 0.25, 0.49}) {
      const Network network = soft_block(model, nu);
      const std::vector<Vector3> x = deformed(network, 2);
      const auto forces = forces_at(network, x);
      BOOST_TEST(norm(forces) > 0.01);
      BOOST_TEST(total(forces).norm() < 1e-13 * norm(forces), name);
      BOOST_TEST(moment(x, forces).norm() < 1e-13 * norm(forces), name);
    }
}

BOOST_AUTO_TEST_CASE(spring_of_zero_length_pulls_nowhere) {
  const Network network = one_spring();
  const std::vector<Vector3> x(2, Vector3(1, 1, 1));
  std::vector<Vector3> forces = forces_at(network, x);
  add_dashpot_forces(network, 1, x, {{Vector3::UnitX(), Vector3::UnitY()}}, forces);
  BOOST_TEST(norm(forces) == 0);
}

// By hand: the reduced mass is 3/4 kg, so c = 2 zeta sqrt(12 * 3/4) = 6 zeta.
BOOST_AUTO_TEST_CASE(dashpot_of_ratio_one_is_critical_for_the_two_masses,
                     *boost::unit_test::tolerance(1e-15)) {
  const Network network = one_spring();
  const Spring& spring = network.springs.front();
  BOOST_TEST(dashpot_constant(network, spring, 1) == 6);
  BOOST_TEST(dashpot_constant(network, spring, 0.2) == 1.2);
  BOOST_TEST(dashpot_constant(network, spring, 0) == 0);
}

// c = 6: only the velocity along the axis counts, and forces are added to what is there.
BOOST_AUTO_TEST_CASE(dashpot_resists_along_its_axis_only,
                     *boost::unit_test::tolerance(1e-15)) {
  const Network network = one_spring();
  const std::vector<Vector3> x{Vector3(0, 0, 0), Vector3(0, 4, 0)};  // turned, stretched
  const std::vector<Vector3> v{Vector3(1, 1, 1), Vector3(-5, 3, 7)};
  std::vector<Vector3> forces{Vector3(1, 0, 0), Vector3(0, 0, 1)};
  add_dashpot_forces(network, 1, x, v, forces);
  BOOST_TEST((forces[0] - Vector3(1, 12, 0)).norm() < 1e-14);
  BOOST_TEST((forces[1] - Vector3(0, -12, 1)).norm() < 1e-14);
}

// The tolerance is round-off of sums of 27 forces at arms of about 4.
BOOST_AUTO_TEST_CASE(dashpots_keep_both_momenta_and_take_energy) {
  for (const auto& [name, model] : models) {
    const Network network = soft_block(model, 0.25);
    const std::vector<Vector3> x = deformed(network, 3);
    const std::vector<Vector3> v = random_field(x.size(), 1, 4);
    std::vector<Vector3> forces(x.size(), Vector3::Zero());
    add_dashpot_forces(network, 0.2, x, v, forces);
    BOOST_TEST(total(forces).norm() < 1e-13 * norm(forces), name);
    BOOST_TEST(moment(x, forces).norm() < 1e-13 * norm(forces), name);
    double power = 0;
    for (std::size_t n = 0; n < x.size(); ++n) power += forces[n].dot(v[n]);
    BOOST_TEST(power < 0, name);
  }
}

// The tolerance is round-off of velocities of about 5.
BOOST_AUTO_TEST_CASE(dashpots_let_a_rigid_motion_pass) {
  const Network network = soft_block(SpringModel::cf, 0.25);
  const std::vector<Vector3> x = deformed(network, 5);
  std::vector<Vector3> v, forces(x.size(), Vector3::Zero());
  for (const Vector3& place : x)
    v.emplace_back(Vector3(1, 2, 3) + Vector3(0.5, -1, 0.7).cross(place));
  add_dashpot_forces(network, 1, x, v, forces);
  BOOST_TEST(norm(forces) < 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
