#include "mss/tissue/thesis_springs.hpp"
#include "meshing/generators/generate_block.hpp"

#include <boost/test/unit_test.hpp>

#include "mss/tissue/thesis_lattice.hpp"
#include "tests/mss/tissue/tissue_scenes.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(thesis_springs_test)

namespace {

tissue::ThesisSpring spring_of(const char* organ, tissue::Elongation elongation) {
  return {tissue::law_of_organ(organ), tissue::hand_fitted_limit(organ), elongation};
}

dynamics::QuasiStaticSettings in_steps(int steps) {
  return {.load = dynamics::ramp(1), .steps = steps};
}

}  // namespace

// The state is homogeneous: its stress is the lattice's own sum, in any cells and number
// of steps.
BOOST_AUTO_TEST_CASE(simple_shear_has_the_lattices_stress) {
  const Mesh mesh = cube(3, h);
  for (const auto elongation :
       {tissue::Elongation::in_metres, tissue::Elongation::relative})
    for (const char* organ : {"liver", "kidney", "spleen"}) {
      const tissue::ThesisSpring spring = spring_of(organ, elongation);
      const Solution solution =
          move_thesis_springs(mesh, in_simple_shear(0.6), spring, in_steps(3));
      BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok), solution.reason);
      const ThesisTissue lattice =
          thesis_tissue(spring.law, spring.strain_limit, elongation, h);
      BOOST_TEST(
          mean_shear_stress(mesh, solution.reactions) == shear_stress(lattice, 0.6),
          boost::test_tools::tolerance(1e-9));
    }
}

// The work of the force on the plate along its way is what the springs have stored: by
// Simpson's rule over 20 steps, of a force that starts as way^.89.
BOOST_AUTO_TEST_CASE(work_between_glued_plates_is_stored) {
  const Mesh mesh = cube(3, h);
  const Vector3 way(0.9 * h, 0, 0.3 * h);
  std::vector<double> work{0};
  const dynamics::Observers observers{.samples = 20,
                                      .sample = [&](const dynamics::Moment& moment) {
                                        double sum = 0;
                                        for (const NodeIndex n : mesh.region("top").nodes)
                                          sum += moment.reactions[n].dot(way);
                                        work.push_back(sum);
                                      }};
  const Solution solution = move_thesis_springs(
      mesh, between_glued_plates(way), spring_of("spleen", tissue::Elongation::relative),
      in_steps(20), observers);
  BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok), solution.reason);
  BOOST_TEST_REQUIRE(work.size() == 21U);
  double integral = 0;
  for (std::size_t i = 0; i + 2 < work.size(); i += 2)
    integral += (work[i] + 4 * work[i + 1] + work[i + 2]) / 60;
  BOOST_TEST(integral == solution.strain_energy, boost::test_tools::tolerance(2e-3));
}

// At rest all tensions vanish at once, and every tangent is infinite.
BOOST_AUTO_TEST_CASE(springs_come_back_to_rest) {
  const Mesh mesh = cube(3, h);
  const Solution solution = move_thesis_springs(
      mesh, between_glued_plates({0.9 * h, 0, 0}),
      spring_of("liver", tissue::Elongation::relative),
      {.load = {{.time = 1, .fraction = 1}, {.time = 2, .fraction = 0}}, .steps = 5});
  BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok), solution.reason);
  for (const Vector3& u : solution.displacements) BOOST_TEST(u.norm() < 1e-6 * h);
}

// What a step tries on its way may pull far harder than where it ends, and must not
// loosen what the end is measured by.
BOOST_AUTO_TEST_CASE(forces_balance_after_wild_trials) {
  const Mesh mesh = cube(3, h);
  const Solution solution =
      move_thesis_springs(mesh, between_glued_plates({0.5 * h, 0, -2 * h}),
                          spring_of("liver", tissue::Elongation::in_metres), in_steps(1));
  BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok), solution.reason);
  Vector3 sum = Vector3::Zero();
  double largest = 0;
  for (const Vector3& reaction : solution.reactions) {
    sum += reaction;
    largest = std::max(largest, reaction.norm());
  }
  BOOST_TEST(sum.norm() < 1e-9 * largest);  // 3e-9 by the largest of all trials
}

BOOST_AUTO_TEST_CASE(cells_that_have_no_lattice_are_refused) {
  const Mesh mesh = generate_block(
      {.size = {h, h, h}, .cells = {2, 2, 2}, .pattern = CellPattern::tetrahedron});
  const Solution solution =
      move_thesis_springs(mesh, in_simple_shear(0.1),
                          spring_of("spleen", tissue::Elongation::relative), in_steps(1));
  BOOST_TEST((solution.status == SolveStatus::refused));
}

BOOST_AUTO_TEST_SUITE_END()
