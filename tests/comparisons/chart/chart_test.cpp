#include "comparisons/chart/chart.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "comparisons/chart/chart_json.hpp"
#include "comparisons/chart/chart_run.hpp"
#include "comparisons/chart/chart_tables.hpp"
#include "comparisons/chart/claims.hpp"
#include "comparisons/chart/pareto.hpp"
#include "comparisons/methods/methods.hpp"
#include "meshing/input_error.hpp"
#include "tests/comparisons/chart/example_chart.hpp"
#include "tests/comparisons/own_folder.hpp"

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

  // A faster one, itself .9 % short of a place.
  ExampleChart close;
  close.add("mss-cf", 4, 1, 12, 0.002);            // 20 % off
  close.add("mss-affine", 4, 2, 11.982, 0.002);    // 19.82 %
  close.add("fem-stvk:q1", 4, 100, 11.97, 0.002);  // 19.7 %
  const Chart three = evaluated(close.chart, close.cases);
  BOOST_TEST((three.front(kind, measure, 0) == std::vector<std::size_t>{0, 2}));
  BOOST_TEST((three.rivals(2, measure, 0) == std::vector<std::size_t>{1}));
  BOOST_TEST((three.rivals(0, measure, 0).empty()));
}

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

// Of a method that this program does not have, as of one that is known.
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

// The foremost models first, the others added to the same chart.
BOOST_AUTO_TEST_CASE(a_quick_chart_becomes_a_whole_one) {
  const OwnFolder own;
  const auto file = own.path / "chart.h5";
  ChartPlan plan = quick_plan("compression", 1, 1);
  plan.across = {2};
  plan.truth_across = 1;
  plan.repeat_for = 0.01;
  const auto quick = chosen_models(plan.models, BodyShape::block);
  for (const ChartModel& one : quick) {
    BOOST_TEST((one.model.cells == CellType::hexahedron), name_of(one.model));
    BOOST_TEST(one.model.linear_solver.empty(), name_of(one.model));
    BOOST_TEST(find_method(one.model.method)->foremost > 0, name_of(one.model));
  }
  // Every family's foremost at rest: compared, whatever else is.
  for (const Family family : {Family::springs, Family::finite_elements})
    BOOST_TEST(std::ranges::count_if(quick, [&](const ChartModel& one) {
                 return one.model.method == foremost(family).front()->name;
               }) > 0);
  const Chart first = make_chart(plan, file);
  BOOST_TEST(first.truths.size() == 1u);
  BOOST_TEST(first.points.size() == quick.size());
  BOOST_TEST(charts_json({first})[0]["quick"] == true);

  plan.models = ChartModels::all;
  const Chart whole = make_chart(plan, file);
  BOOST_TEST(whole.points.size() == chart_models().size());
  BOOST_TEST(charts_json({whole})[0]["quick"] == false);
  for (const ChartPoint& point : first.points) {
    const auto same = std::ranges::find_if(whole.points, [&](const ChartPoint& other) {
      return other.place.model == point.place.model;
    });
    BOOST_REQUIRE(same != whole.points.end());
    BOOST_TEST((same->place.times == point.place.times));
  }
}

BOOST_AUTO_TEST_CASE(a_chart_is_measured_once_and_kept) {
  const OwnFolder own;
  const auto file = own.path / "chart.h5";
  const ChartPlan plan{.scene = "compression",
                       .options = {},
                       .laws = truth_laws(),
                       .across = {2},
                       .threads = {1},
                       .budget = 1,
                       .repeat_for = 0.01,
                       .jobs = 1,
                       .retime = false,
                       .least_models = 0,
                       .truth_across = 1};
  const Chart chart = make_chart(plan, file);
  BOOST_TEST(chart.stored.law == "fem-stvk");
  BOOST_TEST(chart.stored.imposed.value() == 0.05 * 0.05, round_off);
  BOOST_TEST(chart.truths.size() == truth_laws().size());
  BOOST_TEST(chart.points.size() == chart_models().size());
  for (const ChartPoint& point : chart.points) {
    BOOST_TEST_CONTEXT(name_of(point.place.model)) {
      BOOST_TEST(point.is_ok());
      BOOST_TEST(point.seconds().value() > 0);
      BOOST_TEST(*point.place.setup < point.place.timing->maximum);
      BOOST_TEST((point.place.timing->rounds == most_rounds ||
                  point.place.timing->median > plan.repeat_for));
      for (std::size_t i = 0; i < chart.truths.size(); ++i)
        for (const ChartMeasure measure : all_values<ChartMeasure>())
          BOOST_TEST(point.errors[i].of(measure).has_value());
    }
  }
  // A law's own elements are closest to it where they are finest.
  const auto q2 = [&](const std::string& model, const std::string& law) {
    const auto found = std::ranges::find(
        chart.points, model,
        [](const ChartPoint& point) { return name_of(point.place.model); });
    return found->errors.at(chart.truth_of(law).value()).force.value();
  };
  BOOST_TEST(q2("fem-stvk:q2", "fem-stvk") < q2("fem-stvk:q2", "fem-hencky"));
  BOOST_TEST(q2("fem-hencky:q2", "fem-hencky") < q2("fem-stvk:q2", "fem-hencky"));

  // All is there: the same times come back, from the file alone too.
  const Chart again = make_chart(plan, file);
  BOOST_TEST(charts_json({again}).dump() == charts_json({chart}).dump());
  BOOST_TEST(charts_json(stored_charts(file, Revisions::own)).dump() ==
             charts_json({chart}).dump());
  for (const Table& table : chart_tables({chart})) {
    BOOST_TEST(!table.rows.empty(), table.name);
    for (const TableRow& row : table.rows)
      BOOST_TEST(row.cells.size() == table.columns.size(), table.name);
  }

  // Further sizes join the points; those beyond the budget are kept without a time.
  ChartPlan larger = plan;
  larger.across = {4};
  larger.budget = 1e-4;
  const Chart grown = make_chart(larger, file);
  BOOST_TEST(grown.points.size() == 2 * chart_models().size());
  const auto left_out = std::ranges::count_if(grown.points, [](const ChartPoint& point) {
    return !point.found && !point.place.timing;
  });
  BOOST_TEST(left_out > 0);

  // The cheapest models at equilibrium get to the finest cells whatever the budget, and
  // no more of them; a new time leaves none out again.
  const auto reached = [](const Chart& all) {
    std::set<std::string> models;
    for (const ChartPoint& point : all.points)
      if (point.place.kind == ChartKind::equilibrium && point.place.across == 4 &&
          point.place.timing)
        models.insert(name_of(point.place.model));
    return models;
  };
  const std::set<std::string> within = reached(grown);
  larger.least_models = static_cast<int>(within.size()) + 3;
  const Chart before = make_chart(larger, file);
  const std::set<std::string> beyond = reached(before);
  BOOST_TEST(beyond.size() == within.size() + 3);
  BOOST_TEST(std::ranges::includes(beyond, within));

  // New times are of what had one, and of all of it.
  larger.retime = true;
  larger.least_models = 1000;
  const Chart retimed = make_chart(larger, file);
  BOOST_TEST((reached(retimed) == beyond));
  BOOST_TEST_REQUIRE(retimed.points.size() == before.points.size());
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    const StoredChart::Point &old = before.points[i].place,
                             &now = retimed.points[i].place;
    BOOST_TEST(now.key == old.key);
    if (now.across == 4 && now.timing) BOOST_TEST((now.times != old.times));
  }
}

BOOST_AUTO_TEST_CASE(models_beyond_the_budget_are_of_different_names_and_never_fail) {
  const OwnFolder own;
  const ChartPlan plan{.scene = "compression",
                       .options = {{"deformation", Given::from_text("test", "0.35")}},
                       .laws = {},
                       .across = {2, 3},
                       .threads = {1},
                       .budget = 1e-6,
                       .repeat_for = 1e-6,
                       .jobs = 1,
                       .retime = false,
                       .least_models = 1000,
                       .truth_across = 1};
  const Chart chart = make_chart(plan, own.path / "chart.h5");
  std::map<std::string, int> timed;  // on 3 across, by what solvers share
  std::set<std::string> failed;      // on 2
  for (const ChartPoint& point : chart.points) {
    if (point.place.kind != ChartKind::equilibrium || !point.place.timing) continue;
    const std::string name = name_of(point.place.model);
    if (point.place.across == 3) ++timed[name.substr(0, name.find(','))];
    if (point.place.across == 2 && !point.is_ok()) failed.insert(name);
  }
  BOOST_TEST(timed.size() > 5U);
  BOOST_TEST(!failed.empty());
  for (const auto& [name, solvers] : timed) BOOST_TEST(solvers == 1, name);
  for (const std::string& name : failed) BOOST_TEST(timed.count(name) == 0U, name);
}

BOOST_AUTO_TEST_CASE(scenes_without_an_answer_are_refused) {
  const OwnFolder own;
  ChartPlan plan{.scene = "",
                 .options = {},
                 .laws = {},
                 .across = {2},
                 .threads = {1},
                 .budget = 1,
                 .repeat_for = 1,
                 .jobs = 1,
                 .retime = false,
                 .least_models = 0};
  for (const char* scene : {"affine", "traction"}) {
    plan.scene = scene;
    BOOST_CHECK_THROW(make_chart(plan, own.path / "none.h5"), InputError);
    BOOST_TEST(!std::filesystem::exists(own.path / "none.h5"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
