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

BOOST_AUTO_TEST_SUITE_END()
