#include "comparisons/chart/claims.hpp"

#include <boost/test/unit_test.hpp>
#include <set>

#include "comparisons/chart/chart.hpp"
#include "tests/comparisons/chart/example_chart.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(claims_test)

BOOST_AUTO_TEST_CASE(claims_are_of_springs_that_follow_no_other_law) {
  ExampleChart example;
  for (const char* springs : {"mss-hencky", "mss-stvk", "mss-cf"})
    example.add(springs, 4, 1, 14, 0.002);
  example.add("fem-stvk:q1-sri", 4, 2, 13, 0.002);
  example.add("fem-hencky:q1-sri", 4, 2, 13, 0.002);
  const Chart chart = evaluated(example.chart, example.cases);
  std::set<std::size_t> claimed;
  for (const Claim& claim : claims(chart)) claimed.insert(claim.springs);
  BOOST_TEST((claimed == std::set<std::size_t>{1, 2}));
}

BOOST_AUTO_TEST_CASE(claims_are_answered_by_quartiles_and_error_bounds) {
  ExampleChart example;
  example.add("mss-cf", 4, 1, 14, 0.002);           // 40 % off
  example.add("fem-stvk:q1-sri", 4, 2, 13, 0.002);  // 30 %: closer by less than 12.5 %
  example.add("fem-stvk:q1-sri", 2, 0.5, 13.5, 0.002);
  const Chart chart = evaluated(example.chart, example.cases);
  const std::vector<Claim> all = claims(chart);
  BOOST_TEST_REQUIRE(all.size() == 3U);  // a measure each
  const Claim& force = all[0];
  BOOST_TEST((force.is_faster == Answer::yes));
  BOOST_TEST((force.is_as_accurate == Answer::undecided));
  BOOST_TEST(force.rival.value() == 2U);
  BOOST_TEST((force.is_faster_at_equal_accuracy == Answer::no));
  BOOST_TEST(
      claim_text(chart, force) ==
      "mss-cf on 4 across (1 s, 40 % off) is 2 times faster than fem-stvk:q1-sri on "
      "4 across (2 s, 30 % off) and as far off, within 1 % or what the "
      "converged solution is known to. "
      "Not less accurate is fem-stvk:q1-sri on 2 across (0.5 s, 35 % off), 2 "
      "times faster.");

  example.cases.at("mss-cf4").measures.plate_force = 10.5;
  example.chart.points[0].timing = around(2.1);
  const Chart closer = evaluated(example.chart, example.cases);
  const Claim claim = claims(closer).at(0);
  BOOST_TEST((claim.is_faster == Answer::undecided));
  BOOST_TEST((claim.is_as_accurate == Answer::yes));
  BOOST_TEST(!claim.rival.has_value());
  BOOST_TEST(claim_text(closer, claim)
                 .ends_with("2.4 times closer. No finite elements of the chart are as "
                            "accurate as it."));
  BOOST_TEST((claim.is_faster_at_equal_accuracy == Answer::yes));

  // Elements that were not run might have been.
  example.add("fem-stvk:q2", 8, 1, 10, 0.002);
  example.chart.points.back().timing.reset();
  const Chart incomplete = evaluated(example.chart, example.cases);
  const Claim open = claims(incomplete).at(0);
  BOOST_TEST((open.is_faster_at_equal_accuracy == Answer::undecided));
  BOOST_TEST(claim_text(incomplete, open).ends_with("; some of them were not run."));
}

BOOST_AUTO_TEST_CASE(elements_within_what_is_known_are_rivals) {
  ExampleChart example;
  example.add("mss-cf", 4, 1, 14, 0.002);
  example.add("fem-stvk:q1-sri", 4, 0.5, 14.01, 0.002);
  const Claim claim = claims(evaluated(example.chart, example.cases)).at(0);
  BOOST_TEST((claim.is_as_accurate == Answer::undecided));
  BOOST_TEST(claim.rival.value() == 1U);
  BOOST_TEST((claim.is_faster_at_equal_accuracy == Answer::no));
}

BOOST_AUTO_TEST_CASE(errors_within_a_hundredth_are_equal) {
  ExampleChart example;
  example.add("mss-cf", 4, 1, 14, 0.00200);
  example.add("fem-stvk:q1-sri", 4, 2, 14, 0.00199);
  for (const char* key : {"mss-cf4 compared", "fem-stvk:q1-sri4 compared"})
    example.cases.at(key).measures.reference_bar_l2_relative = 1e-9;
  const auto deviation = [&] {
    return claims(evaluated(example.chart, example.cases)).at(2);
  };
  BOOST_TEST((deviation().is_as_accurate == Answer::undecided));
  example.cases.at("fem-stvk:q1-sri4 compared").measures.deviation_l2_relative = 0.0019;
  BOOST_TEST((deviation().is_as_accurate == Answer::no));
  // What the truth may be off on the elements' mesh counts too.
  example.cases.at("fem-stvk:q1-sri4 compared").measures.reference_bar_l2_relative = 2e-4;
  BOOST_TEST((deviation().is_as_accurate == Answer::undecided));
}

BOOST_AUTO_TEST_SUITE_END()
