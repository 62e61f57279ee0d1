#include "comparisons/chart/chart_run.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "comparisons/chart/chart_json.hpp"
#include "comparisons/chart/chart_tables.hpp"
#include "comparisons/methods/methods.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(chart_run_test)

namespace {

const auto round_off = boost::test_tools::tolerance(1e-12);

/// Every point of the chart is ok, timed as planned, and has all errors.
void expect_all_told(const Chart& chart, const ChartPlan& plan) {
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
}

/// The models at equilibrium that have a time on 4 across.
std::set<std::string> timed_on_4(const Chart& all) {
  std::set<std::string> models;
  for (const ChartPoint& point : all.points)
    if (point.place.kind == ChartKind::equilibrium && point.place.across == 4 &&
        point.place.timing)
      models.insert(name_of(point.place.model));
  return models;
}

}  // namespace

// The foremost models come first, and the others are added to the same chart.
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
  expect_all_told(chart, plan);
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
  const std::set<std::string> within = timed_on_4(grown);
  larger.least_models = static_cast<int>(within.size()) + 3;
  const Chart before = make_chart(larger, file);
  const std::set<std::string> beyond = timed_on_4(before);
  BOOST_TEST(beyond.size() == within.size() + 3);
  BOOST_TEST(std::ranges::includes(beyond, within));

  // New times are of what had one, and of all of it.
  larger.retime = true;
  larger.least_models = 1000;
  const Chart retimed = make_chart(larger, file);
  BOOST_TEST((timed_on_4(retimed) == beyond));
  BOOST_TEST_REQUIRE(retimed.points.size() == before.points.size());
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    const StoredChart::Point &old = before.points[i].place,
                             &now = retimed.points[i].place;
    BOOST_TEST(now.key == old.key);
    if (now.across == 4 && now.timing) BOOST_TEST((now.times != old.times));
  }
}

BOOST_AUTO_TEST_CASE(models_beyond_the_budget_are_of_different_names_and_never_fail,
                     *boost::unit_test::label("slow")) {
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
