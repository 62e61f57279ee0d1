#include "dynamics/blocks/explicit_motion.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "meshing/generators/generate_block.hpp"

using namespace springcheck;
using namespace springcheck::dynamics;

BOOST_AUTO_TEST_SUITE(explicit_motion_test)

// A free node of 2 kg under 6 N moves by dt^2 f/m in its first step from rest, and a held
// one as its support does. The lists that the motion was made from are no numbers by
// then.
BOOST_AUTO_TEST_CASE(a_motion_keeps_nothing_of_what_it_was_made_from) {
  const Mesh mesh = generate_block({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  std::vector<Vector3> rest = mesh.nodes(), load(8, Vector3(6, 0, 0));
  std::vector<double> masses(8, 2);
  const auto motion = explicit_motion<double>(
      {.rest = rest,
       .masses = masses,
       .load = load,
       .supports = {{.node = 7, .component = 2, .motion = 0}},
       .blocks = {whole_mesh(mesh)},
       .forces = {.lanes = 1, .add = [](std::size_t, const BlockArrays<double>&) {}}},
      {.integrator = Integrator::semi_implicit_euler,
       .instruction_set = InstructionSet::portable,
       .threads = 1});
  const double none = std::numeric_limits<double>::quiet_NaN();
  rest.assign(8, Vector3::Constant(none));
  load.assign(8, Vector3::Constant(none));
  masses.assign(8, none);
  const AffineDisplacement still{Eigen::Matrix3d::Zero(), Vector3::Zero()},
      stretched{0.5 * Eigen::Matrix3d::Identity(), Vector3::Zero()};
  motion->advance({.dt = 0.5,
                   .kick = 0.5,
                   .load_fraction = 1,
                   .motions_before = {still},
                   .motions = {stretched}});
  const State state = motion->state();
  BOOST_TEST(state.displacements[0] == Vector3(0.75, 0, 0));
  BOOST_TEST(state.displacements[7].z() == 0.5 * mesh.nodes()[7].z());
  BOOST_TEST(state.displacements[7].z() == 0.5);
}

// Every node held goes where the motion has its own point, whether it turns or shifts,
// and as fast as it got there.
BOOST_AUTO_TEST_CASE(held_nodes_follow_their_motion_each_from_its_own_point) {
  const Mesh mesh = generate_block({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  std::vector<Support> supports;
  for (NodeIndex node = 0; node < 8; ++node)
    for (std::uint8_t i = 0; i < 3; ++i)
      supports.push_back({.node = node, .component = i, .motion = node < 4 ? 0U : 1U});
  const std::vector<Vector3> no_load(8, Vector3::Zero());
  const std::vector<double> masses(8, 2);
  const auto motion = explicit_motion<double>(
      {.rest = mesh.nodes(),
       .masses = masses,
       .load = no_load,
       .supports = supports,
       .blocks = {whole_mesh(mesh)},
       .forces = {.lanes = 1, .add = [](std::size_t, const BlockArrays<double>&) {}}},
      {.integrator = Integrator::semi_implicit_euler,
       .instruction_set = InstructionSet::portable,
       .threads = 1});
  const AffineDisplacement still{Eigen::Matrix3d::Zero(), Vector3::Zero()},
      turned{(Eigen::Matrix3d() << 0, -1, .5, 1, 0, 0, 0, 0, .25).finished(),
             Vector3(.5, 0, 0)},
      shifted{Eigen::Matrix3d::Zero(), Vector3(.25, -.5, 1)};
  const double dt = 0.5;
  const auto check = [&](const AffineDisplacement& before,
                         const AffineDisplacement& after) {
    motion->advance({.dt = dt,
                     .kick = dt,
                     .load_fraction = 1,
                     .motions_before = {before, still},
                     .motions = {after, still}});
    const State state = motion->state();
    for (std::size_t n = 0; n < 8; ++n)
      for (int i = 0; i < 3; ++i) {
        const double to = n < 4 ? after.component(mesh.nodes()[n], i) : 0,
                     from = n < 4 ? before.component(mesh.nodes()[n], i) : 0;
        BOOST_TEST(state.displacements[n][i] == to, "node " << n);
        BOOST_TEST(state.velocities[n][i] == (to - from) / dt, "node " << n);
      }
  };
  check(still, turned);
  check(turned, shifted);
  check(shifted, still);
}

BOOST_AUTO_TEST_SUITE_END()
