#include "comparisons/advice/wish.hpp"

#include <boost/test/unit_test.hpp>

#include "tests/comparisons/chart/example_chart.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(wish_test)

namespace {

const auto round_off = boost::test_tools::tolerance(1e-12);

Wish force_within(double tolerance) {
  return {.measures = {ChartMeasure::force},
          .tolerance = tolerance,
          .frame = std::nullopt,
          .budget = 10,
          .threads = 1};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_truths_own_bar_counts_as_error) {
  ExampleChart example;
  example.add("mss-cf", 4, 2, 9, 0.002);  // 10 % off a truth known to 12.5 %
  const Chart chart = evaluated(example.chart, example.cases);
  const Wish loose = force_within(0.23), tight = force_within(0.22);
  BOOST_TEST(Judge(loose, chart).error(0) == 0.225, round_off);
  BOOST_TEST(Judge(loose, chart).meets(0));
  BOOST_TEST(!Judge(tight, chart).meets(0));
  BOOST_TEST(Judge(tight, chart).distance(0) == 0.225 / 0.22, round_off);
  Wish deviation = force_within(0.0031);  // .002, and .1 % for the truth on this mesh
  deviation.measures = {ChartMeasure::deviation};
  BOOST_TEST(Judge(deviation, chart).error(0) == 0.003, round_off);
  BOOST_TEST(Judge(deviation, chart).meets(0));
}

BOOST_AUTO_TEST_CASE(what_the_bar_decides_is_open) {
  ExampleChart example;
  example.add("mss-cf", 4, 2, 9, 0.002);  // 10 % off a truth known to 12.5 %
  const Chart chart = evaluated(example.chart, example.cases);
  const Wish within = force_within(0.226), open = force_within(0.12);
  BOOST_CHECK(Judge(within, chart).proof(0) == Proof::within);
  BOOST_CHECK(Judge(open, chart).proof(0) == Proof::open);
  example.cases["mss-cf4"].measures.plate_force = 7;
  const Chart worse = evaluated(example.chart, example.cases);
  BOOST_CHECK(Judge(open, worse).proof(0) == Proof::beyond);
}

BOOST_AUTO_TEST_CASE(every_measure_counts) {
  ExampleChart example;
  example.add("mss-cf", 4, 2, 9, 0.4);  // 10 +- 12.5 % in force, 40 +- .1 % in deviation
  const Chart chart = evaluated(example.chart, example.cases);
  Wish wish = force_within(0.3);
  wish.measures.push_back(ChartMeasure::deviation);
  BOOST_TEST(Judge(wish, chart).error(0) == 0.401, round_off);
  BOOST_TEST(Judge(wish, chart).off(0) == 0.4, round_off);
  BOOST_CHECK(Judge(wish, chart).proof(0) == Proof::beyond);
}

BOOST_AUTO_TEST_CASE(the_budget_is_part_of_a_wish) {
  ExampleChart example;
  example.add("mss-cf", 4, 30, 9, 0.002);
  const Chart chart = evaluated(example.chart, example.cases);
  const Wish wish = force_within(0.3);
  BOOST_TEST(Judge(wish, chart).meets_tolerance(0));
  BOOST_TEST(!Judge(wish, chart).meets(0));
  BOOST_TEST(Judge(wish, chart).distance(0) == 3, round_off);
}

BOOST_AUTO_TEST_CASE(what_failed_or_is_of_another_kind_is_no_candidate) {
  ExampleChart example;
  example.add("mss-nfd", 4, 1, 10, 0.002).status = Status::wrinkled;
  example.add("mss-cf, double", 4, 1, 10, 0.002, ChartKind::motion);
  example.add("mss-cf", 4, 1, 10, 0.002);
  example.chart.points.back().threads = 2;
  const Chart chart = evaluated(example.chart, example.cases);
  const Wish wish = force_within(1);
  for (std::size_t i = 0; i < 3; ++i) BOOST_TEST(!Judge(wish, chart).is_candidate(i));
}

BOOST_AUTO_TEST_CASE(a_frame_has_whole_steps_below_the_limit) {
  ExampleChart example;
  StoredCase& motion = example.add("mss-cf, double", 4, 1, 10, 0.002, ChartKind::motion);
  motion.dt_limit = 1e-3;
  motion.effort = Effort{};
  motion.effort->steps = 1000;
  const Chart chart = evaluated(example.chart, example.cases);
  const auto frame = frame_of(chart.points[0], 0.02);
  BOOST_TEST(frame.value().steps == 23);  // .02/.0009 = 22.2
  BOOST_TEST(frame->dt == 0.02 / 23, round_off);
  // The 1000 steps take 1.1 s, the upper quartile, of which .1 s is set-up.
  BOOST_TEST(frame->seconds() == 23 * 1e-3, round_off);

  // The frame takes more steps than an int holds.
  BOOST_TEST(frame_of(chart.points[0], 1e12).value().dt > 0.99 * 0.9e-3);

  Wish wish = force_within(0.3);
  wish.frame = 0.02;
  BOOST_TEST(Judge(wish, chart).cost(0).value() == 0.023 / 0.02, round_off);
  BOOST_TEST(Judge(wish, chart).distance(0) == 0.023 / 0.02, round_off);
  BOOST_TEST(!Judge(wish, chart).meets(0));

  motion.dt_limit.reset();
  BOOST_TEST(!Judge(wish, evaluated(example.chart, example.cases)).is_candidate(0));
}

BOOST_AUTO_TEST_SUITE_END()
