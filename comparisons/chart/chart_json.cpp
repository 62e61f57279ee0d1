#include "comparisons/chart/chart_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/chart/chart_models.hpp"
#include "comparisons/chart/claims.hpp"
#include "comparisons/results/result_file.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json value_or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json errors_json(const ChartErrors& errors) {
  Json json = Json::object();
  for (const ChartMeasure measure : all_values<ChartMeasure>())
    json[std::string(name_of(measure))] = value_or_null(errors.of(measure));
  return json;
}

Json number_json(const CheckedNumber& number) {
  return {{"value", number.value},
          {"bar", number.error_bound},
          {"order", value_or_null(number.order)},
          {"element", element_of(number)},
          {"disagreement", value_or_null(number.disagreement)},
          {"resolved", number.is_resolved}};
}

Json point_json(const Chart& chart, std::size_t place_in_chart) {
  const ChartPoint& point = chart.points[place_in_chart];
  const StoredChart::Point& place = point.place;
  const Model& model = place.model;
  const std::string_view precision = model.precision ? name_of(*model.precision) : "";
  Json json{{"model", name_of(model)},
            {"method", model.method},
            {"family", family_of(place)},
            {"element", model.element},
            {"cell_type", name_of(model.cells)},
            {"linear_solver", model.linear_solver},
            {"precision", precision},
            {"kind", std::string(name_of(place.kind))},
            {"across", place.across},
            {"cells", place.cells},
            {"threads", place.threads},
            {"status", status_of(point)},
            {"case", place.key},
            {"lower_quartile", value_or_null(point.seconds_at(&Timing::lower_quartile))},
            {"median", value_or_null(point.seconds())},
            {"upper_quartile", value_or_null(point.seconds_at(&Timing::upper_quartile))},
            {"rounds", place.timing ? Json(place.timing->rounds) : Json()},
            {"fastest_round", value_or_null(point.seconds_at(&Timing::fastest_round))},
            {"slowest_round", value_or_null(point.seconds_at(&Timing::slowest_round))},
            {"setup", value_or_null(place.setup)},
            {"errors", Json::object()},
            {"tells_truth_of", Json::array()}};
  for (std::size_t i = 0; i < chart.truths.size(); ++i) {
    const std::string& law = chart.truths[i].grids.law;
    json["errors"][law] = errors_json(point.errors[i]);
    if (chart.tells_truth(place_in_chart, i)) json["tells_truth_of"].push_back(law);
  }
  return json;
}

Json fronts_json(const Chart& chart) {
  Json json = Json::array();
  for (const ChartKind kind : {ChartKind::equilibrium, ChartKind::motion})
    for (std::size_t truth = 0; truth < chart.truths.size(); ++truth)
      for (const ChartMeasure measure : all_values<ChartMeasure>()) {
        const std::vector<std::size_t> front = chart.front(kind, measure, truth);
        Json heights = Json::array();
        for (const std::size_t i : front)
          heights.push_back(std::max(*chart.points[i].errors[truth].of(measure),
                                     chart.error_bound(i, measure, truth).value_or(0)));
        json.push_back({{"kind", std::string(name_of(kind))},
                        {"law", chart.truths[truth].grids.law},
                        {"measure", std::string(name_of(measure))},
                        {"points", front},
                        {"errors_told", heights}});
      }
  return json;
}

Json chart_json(const Chart& chart) {
  Json json{{"identity", identity_of(chart.stored)},
            {"scene", chart.stored.scene},
            {"law", chart.stored.law},
            {"answer", chart.stored.answer},
            {"machine", chart.stored.machine},
            {"quick", !chart.points.empty() &&
                          std::ranges::all_of(chart.points,
                                              [](const ChartPoint& point) {
                                                return is_foremost(point.place.model);
                                              })},
            {"other_revision",
             chart.stored.revision == build_info::revision ? "" : chart.stored.revision},
            {"truths", Json::array()},
            {"points", Json::array()},
            {"fronts", fronts_json(chart)},
            {"claims", Json::array()}};
  for (const ChartTruth& truth : chart.truths)
    json["truths"].push_back({{"law", truth.grids.law},
                              {"finest_cell_size", truth.grids.grids.cell_sizes.back()},
                              {"answer", number_json(truth.answer)},
                              {"volume_change", number_json(truth.volume_change)},
                              {"bars", errors_json(truth.error_bounds)}});
  for (std::size_t i = 0; i < chart.points.size(); ++i)
    json["points"].push_back(point_json(chart, i));
  for (const Claim& claim : claims(chart))
    json["claims"].push_back(
        {{"kind", std::string(name_of(claim.kind))},
         {"measure", std::string(name_of(claim.measure))},
         {"springs", name_of(chart.points[claim.springs].place.model)},
         {"faster", std::string(name_of(claim.is_faster))},
         {"as_accurate", std::string(name_of(claim.is_as_accurate))},
         {"faster_at_equal_accuracy",
          std::string(name_of(claim.is_faster_at_equal_accuracy))},
         {"words", claim_text(chart, claim)}});
  return json;
}

}  // namespace

std::vector<Chart> stored_charts(const std::filesystem::path& file, Revisions revisions) {
  const std::vector<StoredChart> stored = read_charts(file, revisions);
  if (stored.empty()) return {};
  const std::map<std::string, StoredCase> cases = results_by_stored_key(file);
  std::vector<Chart> charts;
  for (const StoredChart& chart : stored) charts.push_back(evaluated(chart, cases));
  return charts;
}

Json charts_json(const std::vector<Chart>& charts) {
  Json list = Json::array();
  for (const Chart& chart : charts) list.push_back(chart_json(chart));
  return list;
}

}  // namespace springcheck
