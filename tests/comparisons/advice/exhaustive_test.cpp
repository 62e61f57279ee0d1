#include <fmt/format.h>

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>

#include "comparisons/advice/advise.hpp"
#include "comparisons/advice/chart_measurements.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(exhaustive_test)

// The search stops early, by forecasts and by errors that no longer fall. Here everything
// runs that may cost less than two thirds of what was chosen, on every size.

namespace {

struct Scene {
  std::string name;
  double deformation;
};

std::ostream& operator<<(std::ostream& out, const Scene& scene) {
  return out << scene.name;
}

const std::vector<Scene> scenes{
    {"compression", 0.083}, {"shearing", 0.13}, {"torsion", 0.35}};
const std::vector<double> ratios{0.1, 0.37, 0.45};
constexpr double most_times_the_cheapest = 1.5;

/// A result file of the test's own.
struct File {
  OwnFolder folder;
  std::filesystem::path path = folder / "charts.h5";
};

ChartPlan plan_of(const Scene& scene, double poisson_ratio, int truth_across) {
  return {.scene = scene.name,
          .options = {{"nu", poisson_ratio}, {"deformation", scene.deformation}},
          .threads = {1},
          .budget = 5,
          .repeat_for = 0.3,
          .jobs = 1,
          .retime = false,
          .least_models = 0,
          .truth_across = truth_across,
          .truths_file = users_truths_file()};
}

Wish wish_of(double tolerance) {
  return {
      .measures = {ChartMeasure::force, ChartMeasure::volume, ChartMeasure::deviation},
      .tolerance = tolerance,
      .budget = 5,
      .threads = 1};
}

bool is_candidate(const ChartModel& model, const Wish& wish, const ChartPlan& plan) {
  const CaseSettings settings = model_case(plan.scene, plan.options, model, 2);
  return model.kind == wish.kind() &&
         has_poisson_ratio(settings.method, settings.material.poisson_ratio);
}

/// Least cost of what is sound and costs less than `below`, whatever the search thinks.
double cheapest_sound(const Wish& wish, const ChartPlan& plan, Measurements& measurements,
                      double below) {
  for (const ChartModel& model : chart_models()) {
    if (!is_candidate(model, wish, plan)) continue;
    for (const int across : sizes_across) {
      if (measurements.expected_seconds(model, across) > below) break;
      measurements.measure(model, across, below);
    }
  }
  Chart chart = measurements.chart();
  Examiner examiner(wish, BodyShape::block, measurements, chart);
  double least = below;
  for (std::size_t i = 0; i < chart.points.size(); ++i) {
    const Judge judge(wish, chart);
    const ChartModel& model = chart_model(chart.points[i].place.model, BodyShape::block);
    if (!judge.meets(i) || !is_candidate(model, wish, plan)) continue;
    if (*judge.cost(i) < least && examiner.of(i).is_sound()) least = *judge.cost(i);
  }
  return least;
}

/// The error of the model on those cells against the limit of grids twice as fine.
double error_by_finer_truth(const Wish& wish, ChartPlan plan,
                            const StoredChart::Point& place) {
  const File file;
  plan.truth_across = 2 * *plan.truth_across;
  ChartMeasurements finer(plan, file.path);
  finer.measure(chart_model(place.model, BodyShape::block), place.across, INFINITY);
  const Chart chart = finer.chart();
  const Judge judge(wish, chart);
  BOOST_TEST_REQUIRE(judge.is_candidate(0));
  return judge.off(0);
}

double cost_of(const StoredChart::Point& place, const Wish& wish,
               Measurements& measurements) {
  measurements.measure(chart_model(place.model, BodyShape::block), place.across,
                       INFINITY);
  const Chart chart = measurements.chart();
  const auto found = std::ranges::find_if(chart.points, [&](const ChartPoint& point) {
    return point.place.model == place.model && point.place.across == place.across;
  });
  return Judge(wish, chart)
      .cost(static_cast<std::size_t>(found - chart.points.begin()))
      .value();
}

/// Times mean something where nothing else runs.
enum class Costs { told, judged };

/// Checks each tolerance from an empty file: what another search measured is not to help.
void check(const Scene& scene, double poisson_ratio,
           const std::vector<double>& tolerances, int truth_across, Costs costs) {
  const ChartPlan plan = plan_of(scene, poisson_ratio, truth_across);
  std::optional<StoredChart::Point> tighter;  // chosen within the tolerance before
  for (const double tolerance : tolerances) {
    const File file;
    ChartMeasurements measurements(plan, file.path);
    const Wish wish = wish_of(tolerance);
    const Advice advice = advise(wish, plan, measurements);
    if (!advice.chosen) {
      BOOST_TEST(!tighter.has_value(), tolerance);
      BOOST_TEST(cheapest_sound(wish, plan, measurements, wish.budget) == wish.budget);
      BOOST_TEST_MESSAGE(
          fmt::format("{} nu {} within {}: none", scene.name, poisson_ratio, tolerance));
      continue;
    }
    const std::size_t chosen = *advice.chosen;
    const StoredChart::Point place = advice.chart.points[chosen].place;
    const double cost = *Judge(wish, advice.chart).cost(chosen);
    for (const auto& [crossing, why] : advice.crossings) BOOST_TEST(crossing != chosen);
    const double error = error_by_finer_truth(wish, plan, place);
    BOOST_TEST(error <= tolerance);
    const double least = cheapest_sound(wish, plan, measurements, cost);
    BOOST_TEST_MESSAGE(fmt::format(
        "{} nu {} within {}: {} on {} across, by a finer truth {:.3g}, {:.3g} s; "
        "cheapest {:.3g} s, {} crossings",
        scene.name, poisson_ratio, tolerance, name_of(place.model), place.across, error,
        cost, least, advice.crossings.size()));
    if (costs == Costs::judged) BOOST_TEST(cost <= most_times_the_cheapest * least);
    // Timed in one run: small times of two runs differ by more.
    if (tighter && costs == Costs::judged)
      BOOST_TEST(cost <= most_times_the_cheapest * cost_of(*tighter, wish, measurements));
    tighter = place;
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(advice_is_right_by_a_finer_truth) {
  check({"shearing", 0.05}, 0.3, {0.08}, 1, Costs::told);
}

BOOST_TEST_DECORATOR(*boost::unit_test::label("slow"))
BOOST_DATA_TEST_CASE(advice_costs_little_more_than_the_cheapest_everywhere,
                     boost::unit_test::data::make(scenes) *
                         boost::unit_test::data::make(ratios),
                     scene, poisson_ratio) {
  check(scene, poisson_ratio, {0.01, 0.023, 0.05, 0.08, 0.2}, 2, Costs::judged);
}

BOOST_AUTO_TEST_SUITE_END()
