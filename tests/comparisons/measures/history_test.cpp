#include "comparisons/measures/history.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "tests/comparisons/measures/solutions.hpp"

using namespace springcheck;

namespace {

/// Frames of a body of so many nodes after so many samples, all nodes moved by the
/// sample's number.
HistoryFrames frames_after(std::size_t samples, std::size_t nodes) {
  HistoryFrames frames;
  for (std::size_t i = 0; i < samples; ++i)
    keep_frame(frames, i,
               std::vector<Vector3>(nodes, Vector3::Constant(static_cast<double>(i))));
  return frames;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(history_test)

BOOST_AUTO_TEST_CASE(frames_are_samples_evenly_apart) {
  for (const std::size_t samples : {1U, 2U, 3U, 24U, 25U, 51U, 97U, 1000U}) {
    const HistoryFrames frames = frames_after(samples, 2);
    const std::size_t apart = frames.size() < 2 ? 1 : frames[1].sample;
    for (std::size_t f = 0; f < frames.size(); ++f) {
      BOOST_TEST(frames[f].sample == f * apart);
      BOOST_TEST(frames[f].displacements.at(1).y() ==
                 static_cast<double>(frames[f].sample));
    }
    // No further one would have had a place, and none is missing before.
    BOOST_TEST(frames.size() == (samples + apart - 1) / apart);
    BOOST_TEST(frames.size() <= 24U);
    BOOST_TEST(frames.size() >= std::min<std::size_t>(samples, 13));
  }
}

BOOST_AUTO_TEST_CASE(large_bodies_keep_fewer) {
  BOOST_TEST(frames_after(100, 100'000).size() <= 5U);
  BOOST_TEST(frames_after(100, 1'000'000).size() == 2U);
}

// Half of the load the other way: the measure is positive along the load that acted last,
// its history along the whole load.
BOOST_AUTO_TEST_CASE(answers_turn_their_sign_with_the_load,
                     *boost::unit_test::tolerance(1e-12)) {
  for (const std::string scene : {"compression", "shearing", "torsion", "bending"}) {
    BOOST_TEST_CONTEXT(scene) {
      const CaseSettings settings = small_block(scene);
      const Mesh mesh = build_mesh(settings.body);
      const auto answer_at = [&](double fraction) {
        // Every node is moved and pulled, upper ones more: turned, along x and down.
        dynamics::Moment moment{.time = 1,
                                .load_fraction = fraction,
                                .step = 1,
                                .reactions = {},
                                .lever_arms = LeverArms::undeformed,
                                .kinetic_energy = 0,
                                .strain_energy = 1};
        for (const Vector3& x : mesh.nodes()) {
          const Vector3 way(1 - 2 * x.y(), 2 * x.x(), -1);
          moment.displacements.push_back(fraction * 0.01 * x.z() * way);
          moment.reactions.push_back(fraction * x.z() * way);
        }
        return history_sample(settings, mesh, moment).back();
      };
      const double whole = answer_at(1);
      BOOST_TEST(std::abs(whole) > 1e-3);
      BOOST_TEST(answer_at(-0.5) ==
                 (scene == "shearing" ? 0.5 : -0.5) * whole);  // a length has no sign
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
