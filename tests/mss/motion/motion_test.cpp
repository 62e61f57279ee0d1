#include <tbb/global_control.h>

#include <boost/test/unit_test.hpp>
#include <cstring>

#include "tests/dynamics/blocks/shuffled_cells.hpp"
#include "tests/mss/spring_runs.hpp"

using namespace springcheck;
using namespace springcheck::mss;
using dynamics::InstructionSet;
using dynamics::Integrator;
using dynamics::State;

BOOST_AUTO_TEST_SUITE(motion_test)

namespace {

constexpr double h = 0.005;  // [m]

bool same_bits(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(Vector3)) == 0;
}

double largest(const std::vector<Vector3>& vectors) {
  double size = 0;
  for (const Vector3& v : vectors) size = std::max(size, v.norm());
  return size;
}

double largest_difference(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  double size = 0;
  for (std::size_t n = 0; n < a.size(); ++n) size = std::max(size, (a[n] - b[n]).norm());
  return size;
}

State random_state(std::size_t nodes) {
  return {.displacements = random_field(nodes, 0.05 * h, 1),
          .velocities = random_field(nodes, 0.01, 2)};
}

/// Some 8000 cells in random order, on at least four blocks.
const Mesh& large_mesh() {
  static const Mesh mesh = dynamics::shuffled_cells(
      {dynamics::even(26, h), dynamics::even(25, h), dynamics::even(24, h)}, 0.5, 1);
  return mesh;
}

State after_steps(const Mesh& mesh, const Network& network,
                  const DynamicsSettings& settings, InstructionSet set) {
  const Scene scene = in_free_space(tissue_of(0.4));
  const auto motion = motion_of(mesh, scene, network, settings, set);
  motion->restore(random_state(mesh.nodes().size()));
  let_go(*motion, scene, settings.protocol.integrator, 2e-4, 40);
  return motion->state();
}

struct Momenta {
  Vector3 linear = Vector3::Zero(), angular = Vector3::Zero();
};

Momenta momenta(const Network& network, const State& state) {
  Momenta sum;
  for (std::size_t n = 0; n < network.masses.size(); ++n) {
    const Vector3 momentum = network.masses[n] * state.velocities[n];
    sum.linear += momentum;
    sum.angular += (network.rest_positions[n] + state.displacements[n]).cross(momentum);
  }
  return sum;
}

}  // namespace

// Blocks and the order of their sums depend on the mesh alone. More threads than cores
// are allowed, so that there are some here.
BOOST_AUTO_TEST_CASE(any_number_of_threads_gives_the_same_bits) {
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 4);
  for (const SpringModel model : {SpringModel::cf, SpringModel::affine}) {
    const Network network =
        build_network(large_mesh(), tissue_of(0.4), in_shear_modulus_form(model));
    for (const InstructionSet set : dynamics::all_instruction_sets) {
      if (!dynamics::is_available(set)) continue;
      for (const Precision precision :
           {Precision::double_precision, Precision::single_precision}) {
        DynamicsSettings settings =
            settings_of(Integrator::semi_implicit_euler, 1, std::nullopt, 0.1);
        settings.precision = precision;
        const State alone = after_steps(large_mesh(), network, settings, set);
        BOOST_TEST(largest(alone.displacements) < 0.2 * h);  // it has not blown up
        for (const int threads : {2, 4}) {
          settings.threads = threads;
          const State together = after_steps(large_mesh(), network, settings, set);
          BOOST_TEST(same_bits(together.displacements, alone.displacements));
          BOOST_TEST(same_bits(together.velocities, alone.velocities));
        }
      }
    }
  }
}

// Forces agree to 1e-13 and 2e-6 of k L (spring_kernels_test), which moves a node by
// about that part of h in a step; 40 steps amplify it little (measured: up to 1.6e-6 of
// h, and 9e-6 with explicit Euler, which is not stable, in single precision).
BOOST_AUTO_TEST_CASE(kernels_and_plain_loops_make_the_same_run) {
  const Mesh mesh = dynamics::shuffled_cells(
      {dynamics::even(13, h), dynamics::even(12, h), dynamics::graded(11, h)}, 0.7, 2);
  for (const SpringModel model : {SpringModel::cf, SpringModel::affine})
    for (const auto& [name, integrator] : explicit_integrators)
      for (const double zeta : {0., 0.1}) BOOST_TEST_CONTEXT(name << ", zeta " << zeta) {
          const Network network =
              build_network(mesh, tissue_of(0.4), in_shear_modulus_form(model));
          DynamicsSettings settings = settings_of(integrator, 1, std::nullopt, zeta);
          settings.kernel = Kernel::plain;
          const State plain =
              after_steps(mesh, network, settings, dynamics::best_instruction_set());
          BOOST_TEST(largest(plain.displacements) > 0.05 * h);
          settings.kernel = Kernel::fast;
          for (const InstructionSet set : dynamics::all_instruction_sets) {
            if (!dynamics::is_available(set)) continue;
            const State fast = after_steps(mesh, network, settings, set);
            BOOST_TEST(largest_difference(fast.displacements, plain.displacements) <
                       1e-12 * h);
            settings.precision = Precision::single_precision;
            const State rough = after_steps(mesh, network, settings, set);
            settings.precision = Precision::double_precision;
            BOOST_TEST(largest_difference(rough.displacements, plain.displacements) <
                       2e-5 * h);
          }
        }
}

// Restored, a motion forgets where it was: what state() gives and forces_at() leaves are
// enough to go on to the bit.
BOOST_AUTO_TEST_CASE(a_restored_motion_goes_on_to_the_bit) {
  const Mesh mesh = cube(4, h);
  const Scene scene = in_free_space(tissue_of(0.4));
  const Network network =
      build_network(mesh, scene.material, in_shear_modulus_form(SpringModel::cf));
  for (const auto& [name, integrator] : all_integrators) BOOST_TEST_CONTEXT(name) {
      const DynamicsSettings settings = settings_of(integrator, 1, std::nullopt, 0.1);
      const auto whole = motion_of(mesh, scene, network, settings),
                 halves = motion_of(mesh, scene, network, settings);
      const auto go_on = [&](dynamics::Motion& motion) {  // a later step has a full kick
        let_go(motion, scene, Integrator::semi_implicit_euler, 1e-4, 20);
      };
      whole->restore(random_state(mesh.nodes().size()));
      go_on(*whole);
      const State middle = whole->state();
      go_on(*whole);
      halves->restore(random_state(mesh.nodes().size()));
      (void)halves->forces_at(random_state(mesh.nodes().size()));
      halves->restore(middle);
      go_on(*halves);
      BOOST_TEST(same_bits(halves->state().displacements, whole->state().displacements));
      BOOST_TEST(same_bits(halves->state().velocities, whole->state().velocities));
    }
}

// Forces come in pairs along springs and do not turn the body. Semi-implicit Euler and
// Verlet step x_n+1 x v_n+1 = x_n x (v_n + dt a_n): no torque of their own. Rounding of a
// thousand steps.
BOOST_AUTO_TEST_CASE(a_free_body_keeps_its_momenta) {
  const Mesh mesh = dynamics::shuffled_cells(
      {dynamics::even(6, h), dynamics::even(5, h), dynamics::graded(7, h)}, 0.8, 3);
  const Scene scene = in_free_space(tissue_of(0.4));
  const State start = random_state(mesh.nodes().size());
  for (const StrainMeasure measure : all_measures)
    for (const auto& [name, integrator] : all_integrators)
      for (const double zeta : {0., 0.2})
        BOOST_TEST_CONTEXT(name << ", zeta " << zeta << ", strain measure "
                                << static_cast<int>(measure)) {
          const Network network =
              build_network(mesh, scene.material, springs_in(measure));
          const Momenta before = momenta(network, start);
          const bool is_implicit = integrator == Integrator::implicit_euler;
          const auto motion = motion_of(mesh, scene, network,
                                        settings_of(integrator, 1, std::nullopt, zeta));
          motion->restore(start);
          let_go(*motion, scene, integrator, is_implicit ? 1e-3 : 1e-4,
                 is_implicit                                ? 20
                 : integrator == Integrator::explicit_euler ? 100
                                                            : 1000);
          const Momenta after = momenta(network, motion->state());
          // Implicit Euler's equations are solved to 1e-10.
          const double round_off = is_implicit ? 1e-8 : 1e-11;
          BOOST_TEST((after.linear - before.linear).norm() <
                     round_off * before.linear.norm());
          if (integrator == Integrator::semi_implicit_euler ||
              integrator == Integrator::verlet)
            BOOST_TEST((after.angular - before.angular).norm() <
                       round_off * before.angular.norm());
        }
}

BOOST_AUTO_TEST_SUITE_END()
