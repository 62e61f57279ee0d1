#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cmath>
#include <thread>

#include "comparisons/running/timing.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(timing_test)

namespace {

/// Work of scripted times, the last of which repeats.
struct Script {
  std::vector<double> times;
  std::size_t runs = 0;

  double operator()() { return times[std::min(runs++, times.size() - 1)]; }
};

}  // namespace

BOOST_AUTO_TEST_CASE(quantiles_are_interpolated) {
  const Timing timing = timing_of({{4, 1, 3, 2}});
  BOOST_TEST(timing.repetitions == 4);
  BOOST_TEST(timing.minimum == 1);
  BOOST_TEST(timing.lower_quartile == 1.75);
  BOOST_TEST(timing.median == 2.5);
  BOOST_TEST(timing.upper_quartile == 3.25);
  BOOST_TEST(timing.maximum == 4);
  BOOST_TEST(timing_of({{7}}).upper_quartile == 7);
}

BOOST_AUTO_TEST_CASE(the_warm_up_does_not_count) {
  Script script{{100, 1}};
  const Timing timing = timing_of({timed([&] { return script(); }, 10)});
  BOOST_TEST(timing.maximum == 1);
}

BOOST_AUTO_TEST_CASE(repetitions_end_when_the_median_is_quiet) {
  Script script{{1, 1, 1, 1, 5}};
  const Timing timing = timing_of({timed([&] { return script(); }, 10)});
  BOOST_TEST(timing.repetitions == 3);  // 1, 1, 1: two medians that did not change
  BOOST_TEST(script.runs == 4U);
  // A median that wanders goes on to the most there are.
  double rising = 1;
  BOOST_TEST(timed([&] { return rising *= 1.5; }, 10).size() == 25U);
}

BOOST_AUTO_TEST_CASE(work_as_long_as_the_budget_runs_once) {
  int runs = 0;
  const std::vector<double> times = timed(
      [&] {
        ++runs;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        return 0.02;
      },
      0.01);
  BOOST_TEST(runs == 1);
  BOOST_TEST((times == std::vector{0.02}));
}

BOOST_AUTO_TEST_CASE(larger_sizes_are_expected_to_grow_as_the_last_two_did) {
  BOOST_TEST(expected_seconds({}, 10) == 0);
  BOOST_TEST(expected_seconds({{10, 3}}, 20) == 6, boost::test_tools::tolerance(1e-12));
  // The exponent expected is kept between 1 and 5/2.
  for (const auto& [exponent, expected] :
       {std::pair(1.5, 1.5), std::pair(0., 1.), std::pair(4., 2.5)})
    BOOST_TEST(expected_seconds({{1, 50}, {10, 1}, {40, std::pow(4, exponent)}}, 80) ==
                   std::pow(4, exponent) * std::pow(2, expected),
               boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(rounds_count_together_and_by_their_medians) {
  const Timing timing = timing_of({{1, 2, 3}, {5}, {4, 4}});
  BOOST_TEST(timing.repetitions == 6);
  BOOST_TEST(timing.rounds == 3);
  // The median is that of 1, 1 + 1/12, ... 3, 25 times 5 and 25 times 4.
  BOOST_TEST(timing.median == 4);
  BOOST_TEST(timing.lower_quartile == 1 + 18.5 / 12, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(timing.upper_quartile == 5);
  BOOST_TEST(timing.minimum == 1);
  BOOST_TEST(timing.maximum == 5);
  BOOST_TEST(timing.fastest_round == 2);
  BOOST_TEST(timing.slowest_round == 5);
  BOOST_TEST(scaled(timing, 1, 2).slowest_round == 8);
  const Timing drifting = timing_of({{1, 1, 1}, {2, 2, 2, 2, 2, 2}, {3}});
  BOOST_TEST(drifting.lower_quartile == 1);
  BOOST_TEST(drifting.median == 2);
  BOOST_TEST(drifting.upper_quartile == 3);
}

BOOST_AUTO_TEST_CASE(times_are_told_apart_beyond_their_rounds) {
  const Timing steady = timing_of({{1}, {1}, {1.1}}),
               drifting = timing_of({{1.3, 1.3, 1.3}, {1.05}, {1.3}}),
               slower = timing_of({{1.3}, {1.15}, {1.4}}),
               little_slower = timing_of({{1.2}, {1.2}, {1.2}});
  BOOST_TEST(!is_less(steady, drifting));
  BOOST_TEST(is_less(steady, slower));
  BOOST_TEST(!is_less(slower, steady));
  BOOST_TEST(!is_less(steady, little_slower));  // by less than a fifth
  // A single round tells a fifth.
  const Timing once = timing_of({{1, 1, 1}});
  BOOST_TEST(!is_less(once, timing_of({{1.2, 1.2, 1.2}})));
  BOOST_TEST(is_less(once, timing_of({{1.3, 1.3, 1.3}})));
  BOOST_TEST(!is_less(once, timing_of({{0.7, 1.3, 2}})));  // its quartiles overlap
}

BOOST_AUTO_TEST_SUITE_END()
