#include "comparisons/chart/chart.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "comparisons/chart/chart_json.hpp"
#include "comparisons/chart/chart_models.hpp"
#include "comparisons/chart/chart_tables.hpp"
#include "comparisons/chart/claims.hpp"
#include "comparisons/chart/pareto.hpp"
#include "tests/comparisons/chart/example_chart.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(chart_test)

namespace {

const auto round_off = boost::test_tools::tolerance(1e-12);

}  // namespace

BOOST_AUTO_TEST_CASE(a_front_is_of_worthwhile_gains) {
  const std::vector<Cost> points{
      {.error = 0.1, .seconds = 3},    {.error = 0.3, .seconds = 1},
      {.error = 0.3, .seconds = 2},     // slower, no better
      {.error = 0.0995, .seconds = 4},  // .5 % better
      {.error = 0.05, .seconds = 5},   {.error = {}, .seconds = 0.1},
      {.error = 0.01, .seconds = {}}};
  BOOST_TEST((pareto_front(points) == std::vector<std::size_t>{1, 0, 4}));
}

BOOST_AUTO_TEST_CASE(errors_are_told_from_the_limit_of_the_truth) {
  ExampleChart example;
  example.add("mss-cf", 4, 2, 9, 0.002);
  const Chart chart = evaluated(example.chart, example.cases);
  BOOST_TEST_REQUIRE(chart.truths.size() == 1U);
  const ChartTruth& truth = chart.truths[0];
  BOOST_TEST(truth.answer.value == 10, round_off);
  BOOST_TEST(truth.answer.order.value() == 2, round_off);
  BOOST_TEST(truth.error_bounds.force.value() == 0.125, round_off);  // 2.25 of |q* - q3|
  BOOST_TEST(truth.volume_change.value == -0.02, round_off);
  BOOST_TEST(truth.error_bounds.volume.value() == 2.25 / 2880 / 0.05, round_off);
  BOOST_TEST(truth.error_bounds.deviation.value() == 1e-3);
  const ChartErrors& errors = chart.points.at(0).errors.at(0);
  BOOST_TEST(errors.force.value() == 0.1, round_off);
  BOOST_TEST(errors.volume.value() == 0.001 / 0.05, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(errors.deviation.value() == 0.002);
  BOOST_TEST(chart.points[0].deviation_error_bounds[0].value() == 1e-3);
}

// The check's limit of the force is 80/9/8 below the truth's, 10, and its error bound 4
// times its last change, 10/9. The volume's check is exact, its error bound the solvers'
// noise.
BOOST_AUTO_TEST_CASE(a_truth_is_at_least_as_unsure_as_its_check_is_off) {
  ExampleChart example;
  example.check_truth();
  example.chart.truths[0].places_apart = 0.005;
  example.add("mss-cf", 4, 2, 9, 0.002);
  Chart chart = evaluated(example.chart, example.cases);
  const ChartTruth& truth = chart.truths.at(0);
  BOOST_TEST(truth.answer.value == 10, round_off);
  BOOST_TEST(!truth.answer.is_of_check);
  BOOST_TEST(truth.answer.disagreement.value() == 10. / 9, round_off);
  BOOST_TEST(truth.error_bounds.force.value() == 0.125, round_off);
  BOOST_TEST(truth.volume_change.is_of_check);
  BOOST_TEST(truth.volume_change.value == -0.02);
  BOOST_TEST(truth.error_bounds.deviation.value() == 0.005);
  BOOST_TEST(chart.points.at(0).deviation_error_bounds[0].value() == 0.005);

  for (const char* key : {"c1", "c2", "c3"})
    *example.cases.at(key).measures.plate_force += 6;
  chart = evaluated(example.chart, example.cases);
  const TableRow apart = truths_table({chart}).rows.at(0);
  BOOST_TEST(!chart.truths.at(0).answer.is_resolved);
  BOOST_TEST(apart.notes.size() == 1U);
  BOOST_TEST(apart.cases.size() == 6U);

  example.cases.at("c2").status = Status::indefinite;
  const Chart unchecked = evaluated(example.chart, example.cases);
  BOOST_TEST(!unchecked.truths.at(0).answer.disagreement.has_value());
  BOOST_TEST(truths_table({unchecked}).rows.at(0).cells[7].text == "not checked");
}

// Whatever solved it: the grid of another solver has another key.
BOOST_AUTO_TEST_CASE(a_point_that_tells_the_truth_says_so) {
  ExampleChart example;
  example.check_truth();
  example.add("fem-stvk:q2", 4, 2, 9, 0.002);
  example.add("fem-stvk:q2, direct", 4, 1, 9.1, 0.002);
  example.add("fem-stvk:q2", 8, 5, 9.5, 0.002);
  example.add("fem-stvk:q1-sri", 4, 1, 9, 0.002);
  example.chart.points[0].key = "t1";
  example.chart.points[3].key = "c3";
  const Chart chart = evaluated(example.chart, example.cases);
  for (const std::size_t i : {0, 1, 3}) BOOST_TEST(chart.tells_truth(i, 0));
  BOOST_TEST(!chart.tells_truth(2, 0));
  BOOST_TEST((charts_json({chart})[0]["points"][1]["tells_truth_of"] ==
              nlohmann::ordered_json{"fem-stvk"}));
  std::vector<std::size_t> notes;
  for (const TableRow& row : points_table({chart}).rows)
    notes.push_back(row.notes.size());
  BOOST_TEST(notes == (std::vector<std::size_t>{1, 1, 0, 1}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(without_an_imposed_displacement_the_truths_answer_stands_for_it) {
  ExampleChart example;
  example.chart.imposed.reset();
  example.add("mss-cf", 4, 2, 9, 0.002);
  const Chart chart = evaluated(example.chart, example.cases);
  BOOST_TEST(chart.truths.at(0).imposed == 10, round_off);
}

BOOST_AUTO_TEST_CASE(a_law_whose_grid_failed_has_no_truth) {
  ExampleChart example;
  example.add("mss-cf", 4, 2, 9, 0.002);
  example.cases.at("t2").status = Status::indefinite;
  const Chart chart = evaluated(example.chart, example.cases);
  BOOST_TEST(chart.truths.empty());
  BOOST_TEST(chart.points.size() == 1U);
  BOOST_TEST(claims(chart).empty());
}

BOOST_AUTO_TEST_CASE(motions_are_told_by_the_simulated_second) {
  ExampleChart example;
  example.add("mss-cf, double", 4, 2, 9, 0.002, ChartKind::motion);
  const Chart chart = evaluated(example.chart, example.cases);
  BOOST_TEST(chart.points.at(0).seconds().value() == 0.2, round_off);
}

BOOST_AUTO_TEST_CASE(times_are_told_from_each_other_by_their_quartiles) {
  ExampleChart example;
  for (const double seconds : {1., 1.2, 1.3})  // quartiles 10 % beside them
    example.add("mss-cf", static_cast<int>(10 * seconds), seconds, 9, 0.002);
  Chart chart = evaluated(example.chart, example.cases);
  const auto& points = chart.points;
  BOOST_TEST(!points[0].is_faster_than(points[1]));  // 1.1 and 1.08
  BOOST_TEST(points[0].is_faster_than(points[2]));   // 1.1 and 1.17
  BOOST_TEST(!points[2].is_faster_than(points[0]));
  // A single run has no quartiles: it tells a fifth.
  const auto once = [](double seconds) { return timing_of({{seconds}}); };
  chart.points[0].place.timing = once(1);
  chart.points[1].place.timing = once(1.2);
  chart.points[2].place.timing = once(1.3);
  BOOST_TEST(!points[0].is_faster_than(points[1]));
  BOOST_TEST(points[0].is_faster_than(points[2]));
}

BOOST_AUTO_TEST_CASE(failed_states_have_no_place_on_a_front) {
  ExampleChart example;
  example.add("mss-nfd", 4, 1, 12, 0.002).status = Status::wrinkled;
  example.add("mss-cf", 4, 2, 12, 0.002);
  example.add("mss-cf", 8, 20, 11.2, 0.002);
  example.add("fem-stvk:q2", 8, 30, 11.2,
              0.002);  // both below the truth's error bound of .125 ...
  example.add("mss-fd", 8, 5, 12, 0.002, ChartKind::motion);
  Chart chart = evaluated(example.chart, example.cases);
  BOOST_TEST((chart.front(ChartKind::equilibrium, ChartMeasure::force, 0) ==
              std::vector<std::size_t>{1, 2}));  // ... where they count as equal
  BOOST_TEST((chart.front(ChartKind::motion, ChartMeasure::force, 0) ==
              std::vector<std::size_t>{4}));
}

BOOST_AUTO_TEST_CASE(rivals_may_take_a_place_on_the_front) {
  ExampleChart example;
  const auto kind = ChartKind::equilibrium;
  example.add("mss-cf", 4, 1, 14, 0.002);           // on the front, 40 % off
  example.add("mss-fd", 4, 1.1, 14, 0.002);         // as accurate, not told to be slower
  example.add("mss-affine", 4, 1.1, 14.03, 0.002);  // but for less than 1 %
  example.add("mss-affine", 8, 1.1, 14.1, 0.002);   // less accurate
  example.add("fem-hencky:q1", 4, 1.1, 13.9, 0.002);  // on the front too
  example.add("fem-stvk:q1", 4, 2, 14, 0.002);        // slower
  example.add("mss-nfd", 4, 1, 14, 0.002).status = Status::wrinkled;
  example.add("mss-cf, double", 4, 10, 14, 0.002, ChartKind::motion);
  example.add("fem-stvk:q1-sri", 4, 5, 12, 0.002);  // alone
  const Chart chart = evaluated(example.chart, example.cases);
  const auto measure = ChartMeasure::force;
  BOOST_TEST((chart.front(kind, measure, 0) == std::vector<std::size_t>{0, 4, 8}));
  BOOST_TEST((chart.rivals(0, measure, 0) == std::vector<std::size_t>{1, 2, 4}));
  BOOST_TEST((chart.rivals(4, measure, 0).empty()));
  BOOST_TEST((chart.rivals(8, measure, 0).empty()));

  // A faster model is itself .9 % short of a place.
  ExampleChart close;
  close.add("mss-cf", 4, 1, 12, 0.002);            // 20 % off
  close.add("mss-affine", 4, 2, 11.982, 0.002);    // 19.82 %
  close.add("fem-stvk:q1", 4, 100, 11.97, 0.002);  // 19.7 %
  const Chart three = evaluated(close.chart, close.cases);
  BOOST_TEST((three.front(kind, measure, 0) == std::vector<std::size_t>{0, 2}));
  BOOST_TEST((three.rivals(2, measure, 0) == std::vector<std::size_t>{1}));
  BOOST_TEST((three.rivals(0, measure, 0).empty()));
}

BOOST_AUTO_TEST_CASE(deviations_are_held_against_the_bar_of_their_own_mesh) {
  ExampleChart example;
  example.add("mss-cf", 4, 1, 14, 0.002);
  example.add("fem-stvk:q2", 8, 2, 14, 0.0005);
  example.cases.at("mss-cf4 compared").measures.reference_bar_l2_relative = 0.001;
  example.cases.at("fem-stvk:q28 compared").measures.reference_bar_l2_relative = 1e-4;
  const Chart chart = evaluated(example.chart, example.cases);
  for (const TableRow& row : front_table({chart}).rows)
    if (row.cells[3].text == "deviation") BOOST_TEST(row.notes.empty());
  const auto front = charts_json({chart})[0]["fronts"][2];  // of equilibria
  BOOST_TEST(front["measure"] == "deviation");
  BOOST_TEST((front["errors_told"] == nlohmann::ordered_json{0.002, 0.0005}));
}

// The file may give the family of a method that this program does not have; that of one
// that it has is known.
BOOST_AUTO_TEST_CASE(the_family_of_a_point_is_the_files_or_else_its_methods) {
  ExampleChart example;
  example.add("mss-cf", 4, 2, 10, 0.002);
  example.add("ext-springs", 4, 2, 10, 0.002);
  BOOST_TEST(family_of(example.chart.points[0]) == "springs");
  BOOST_TEST(family_of(example.chart.points[1]) == "");
  example.chart.points[1].family = "springs";
  const Chart chart = evaluated(example.chart, example.cases);
  BOOST_TEST(charts_json({chart})[0]["points"][1]["family"] == "springs");
}

BOOST_AUTO_TEST_CASE(points_without_a_time_say_why) {
  ExampleChart example;
  example.add("fem-stvk:q2", 4, 2, 10, 0.002);
  example.chart.points.back().timing.reset();
  example.chart.points.back().left_out = "over budget";
  const Chart chart = evaluated(example.chart, example.cases);
  BOOST_TEST(status_of(chart.points[0]) == "over budget");
  BOOST_TEST(chart.front(ChartKind::equilibrium, ChartMeasure::force, 0).empty());
}

BOOST_AUTO_TEST_CASE(cells_across_are_cubes) {
  BOOST_TEST((cells_across({0.05, 0.05, 0.05}, 10) == Cells{10, 10, 10}));
  BOOST_TEST((cells_across({0.4, 0.4, 2.4}, 4) == Cells{4, 4, 24}));
  BOOST_TEST((cells_across({0.3, 0.1, 0.25}, 2) == Cells{6, 2, 5}));
}

BOOST_AUTO_TEST_SUITE_END()
