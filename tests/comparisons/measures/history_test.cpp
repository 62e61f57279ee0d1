#include "comparisons/measures/history.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>

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

BOOST_AUTO_TEST_SUITE_END()
