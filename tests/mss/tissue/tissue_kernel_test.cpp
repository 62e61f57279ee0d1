#include <boost/test/unit_test.hpp>

#include "meshing/generators/disc.hpp"
#include "meshing/generators/generate_block.hpp"
#include "mss/tissue/tissue_motion.hpp"
#include "tests/mss/tissue/tissue_scenes.hpp"

using namespace springcheck;
using namespace springcheck::mss;
using dynamics::State;

BOOST_AUTO_TEST_SUITE(tissue_kernel_test)

namespace {

double largest(const std::vector<Vector3>& vectors) {
  double size = 0;
  for (const Vector3& x : vectors)
    if (!(x.norm() <= size)) size = x.norm();  // also what is not a number
  return size;
}

double difference(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  BOOST_TEST_REQUIRE(a.size() == b.size());
  double size = 0;
  for (std::size_t n = 0; n < a.size(); ++n)
    if (!((a[n] - b[n]).norm() <= size)) size = (a[n] - b[n]).norm();
  return size;
}

/// Two bodies' memories A_i, without the first tensor of each cell.
double difference(const std::vector<double>& a, const std::vector<double>& b,
                  std::size_t state_size) {
  BOOST_TEST_REQUIRE(a.size() == b.size());
  double size = 0;
  for (std::size_t n = 0; n < a.size(); ++n)
    if (n % state_size >= 6) size = std::max(size, std::abs(a[n] - b[n]));
  return size;
}

struct Named {
  std::string name;
  Mesh mesh;
};

/// Cells all alike and in a grid, in a grid, and free; of numbers that fill no register,
/// the first in more blocks than one.
std::vector<Named> meshes() {
  const Block long_block{.size = {11 * h, 10 * h, 12 * h}, .cells = {11, 10, 12}};
  const Block block{.size = {5 * h, 3 * h, 4 * h}, .cells = {5, 3, 4}};
  Block distorted = block;
  distorted.distortion = 0.2;
  return {{"alike", generate_block(long_block)},
          {"distorted", generate_block(distorted)},
          {"disc", generate_disc(
                       {.diameter = 6 * h, .height = 2 * h, .across = 6, .layers = 2})}};
}

}  // namespace

// A twentieth of the edge in every direction, so that no term of the law is small. What
// is not the same is the order of sums, and powers by series: a few last places, of
// forces that cancel to a hundredth. In free meshes cells that differ by 1e-9 of their
// size have one shape, and plain loops take F from positions, which at rest is then I to
// 1e-11.
BOOST_AUTO_TEST_CASE(kernels_step_as_plain_loops_do) {
  for (const auto& [name, mesh] : meshes())
    for (const char* organ : {"spleen", "liver"}) {
      const TissueBody body = build_tissue_body(mesh, solid_of(organ, 0.45), density);
      Scene scene = between_glued_plates({0.1 * h, 0, 0.05 * h});
      scene.gravity = {3, -2, -9.81};
      const auto motion = [&](Kernel kernel, dynamics::InstructionSet set,
                              int threads = 1) {
        auto made = std::make_unique<TissueMotion>(
            mesh, scene, body,
            TissueMotionSettings{.integrator = dynamics::Integrator::semi_implicit_euler,
                                 .threads = threads,
                                 .kernel = kernel},
            set);
        made->restore({.displacements = random_field(mesh.nodes().size(), 0.05 * h, 1),
                       .velocities = random_field(mesh.nodes().size(), 0.2 * h, 1)});
        for (int step = 1; step <= 20; ++step)
          made->advance(
              {.dt = 1e-5,
               .kick = 1e-5,
               .load_fraction = step / 20.,
               .motions_before = dynamics::support_motions(scene, (step - 1) / 20.),
               .motions = dynamics::support_motions(scene, step / 20.)});
        return made;
      };
      const auto plain = motion(Kernel::plain, dynamics::InstructionSet::portable);
      const State expected = plain->state();
      const std::vector<Vector3> forces = plain->forces_at(expected);
      BOOST_TEST(largest(expected.velocities) > 0.1 * h);
      BOOST_TEST(largest(expected.velocities) < 3000 * h);  // of stiff cells, that swing
      for (const dynamics::InstructionSet set : dynamics::all_instruction_sets) {
        if (!dynamics::is_available(set)) continue;
        const double round_off = name == "disc" ? 1e-10 : 1e-12;
        BOOST_TEST_CONTEXT(name << ", " << organ << ", " << dynamics::name_of(set)) {
          const auto fast = motion(Kernel::fast, set);
          const State state = fast->state();
          BOOST_TEST(difference(motion(Kernel::fast, set, 2)->state().displacements,
                                state.displacements) == 0);
          BOOST_TEST(difference(state.displacements, expected.displacements) <
                     round_off * largest(expected.displacements));
          BOOST_TEST(difference(state.velocities, expected.velocities) <
                     10 * round_off * largest(expected.velocities));
          BOOST_TEST(difference(fast->forces_at(state), forces) <
                     10 * round_off * largest(forces));
          BOOST_TEST(difference(fast->memories(), plain->memories(),
                                tissue::state_size(body.solid.shear.branches.size())) <
                     round_off);
        }
      }
    }
}

// Looking at forces elsewhere leaves the memories, and on from where it was the motion
// goes the same way, to the rounding of sums.
BOOST_AUTO_TEST_CASE(a_look_changes_nothing) {
  for (const auto& [name, mesh] : meshes()) {
    const TissueBody body = build_tissue_body(mesh, solid_of("spleen", 0.45), density);
    const Scene scene = between_glued_plates({0, 0, 0});
    const auto end = [&](bool looks) {
      TissueMotion motion(mesh, scene, body,
                          {.integrator = dynamics::Integrator::semi_implicit_euler});
      motion.restore({.displacements = random_field(mesh.nodes().size(), 0.1 * h, 1),
                      .velocities = random_field(mesh.nodes().size(), 0., 1)});
      const auto still = dynamics::support_motions(scene, 1);
      for (int step = 0; step < 20; ++step) {
        if (looks && step == 10) {
          const State here = motion.state();
          const std::vector<double> memories = motion.memories();
          static_cast<void>(motion.forces_at(
              {.displacements = random_field(mesh.nodes().size(), 0.2 * h, 1),
               .velocities = random_field(mesh.nodes().size(), h, 1)}));
          BOOST_TEST((motion.memories() == memories));
          motion.restore(here);
        }
        motion.advance({.dt = 2e-5,
                        .kick = 2e-5,
                        .load_fraction = 1,
                        .motions_before = still,
                        .motions = still});
      }
      return motion.state().displacements;
    };
    const std::vector<Vector3> expected = end(false);
    BOOST_TEST(difference(end(true), expected) < 1e-12 * largest(expected), name);
  }
}

// Cells pressed through themselves: |det F| of the law, and the volume's own push.
BOOST_AUTO_TEST_CASE(
    kernels_have_the_plain_forces_of_inverted_cells_and_without_dashpot) {
  for (const auto& [name, mesh] : meshes()) {
    tissue::Solid solid = solid_of("kidney", 0.3);
    solid.shear.viscosity = 0;
    const TissueBody body = build_tissue_body(mesh, solid, density);
    const auto forces = [&](Kernel kernel) {
      std::vector<Vector3> moves = random_field(mesh.nodes().size(), 0.05 * h, 2);
      for (std::size_t n = 0; n < moves.size(); ++n)
        moves[n].z() -= 1.7 * mesh.nodes()[n].z();
      return TissueMotion(mesh, between_glued_plates({0, 0, 0}), body,
                          {.integrator = dynamics::Integrator::semi_implicit_euler,
                           .kernel = kernel})
          .forces_at({.displacements = moves,
                      .velocities = random_field(mesh.nodes().size(), h, 3)});
    };
    const std::vector<Vector3> expected = forces(Kernel::plain);
    BOOST_TEST(difference(forces(Kernel::fast), expected) < 1e-11 * largest(expected),
               name);
  }
}

BOOST_AUTO_TEST_SUITE_END()
