#include "comparisons/chart/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/chart/pareto.hpp"
#include "comparisons/methods/methods.hpp"

namespace springcheck {
namespace {

using Cases = std::map<std::string, StoredCase>;

const StoredCase* find(const Cases& cases, const std::string& key) {
  const auto found = cases.find(key);
  return found == cases.end() ? nullptr : &found->second;
}

/// The cost of a candidate for the front; it is without a time or an error for other
/// points.
Cost cost_of(const Chart& chart, std::size_t place, ChartKind kind, ChartMeasure measure,
             std::size_t truth) {
  const ChartPoint& point = chart.points[place];
  const auto& error = point.errors[truth].of(measure);
  if (point.place.kind != kind || !point.is_ok() || !error) return {};
  return {.error = std::max(*error, chart.error_bound(place, measure, truth).value_or(0)),
          .seconds = point.seconds()};
}

}  // namespace

std::optional<double> ChartPoint::seconds_at(double Timing::*quantile) const {
  if (!place.timing) return std::nullopt;
  return place.timing.value().*quantile / place.simulated.value_or(1);
}

std::optional<double> ChartPoint::seconds() const {
  return seconds_at(&Timing::median);
}

bool ChartPoint::is_faster_than(const ChartPoint& other) const {
  return is_less(
      scaled(place.timing.value(), 0, 1 / place.simulated.value_or(1)),
      scaled(other.place.timing.value(), 0, 1 / other.place.simulated.value_or(1)));
}

std::string time_text(const ChartPoint& point) {
  return fmt::format("{:.3g} s{}", point.seconds().value(),
                     point.place.kind == ChartKind::motion ? " per simulated s" : "");
}

std::string family_of(const StoredChart::Point& point) {
  if (!point.family.empty()) return point.family;
  const Method* method = find_method(point.model.method);
  return method == nullptr ? "" : std::string(name_of(method->family));
}

std::string status_of(const ChartPoint& point) {
  if (!point.place.timing) return point.place.left_out.value_or("not run");
  if (point.found) return std::string(name_of(point.found->status));
  return "not in the file";
}

std::optional<std::size_t> Chart::truth_of(const std::string& law) const {
  const auto found = std::ranges::find(
      truths, law, [](const ChartTruth& truth) { return truth.grids.law; });
  if (found == truths.end()) return std::nullopt;
  return static_cast<std::size_t>(found - truths.begin());
}

bool Chart::tells_truth(std::size_t point, std::size_t truth) const {
  const auto cells_of = [](const StoredChart::Point& place) {
    Model model = place.model;
    model.linear_solver.clear();
    return std::pair(model, place.across);
  };
  return std::ranges::any_of(stored.points, [&](const StoredChart::Point& other) {
    return truths[truth].grids.has(other.key) &&
           cells_of(other) == cells_of(points[point].place);
  });
}

std::optional<double> Chart::error_bound(std::size_t point, ChartMeasure measure,
                                         std::size_t truth) const {
  return measure == ChartMeasure::deviation ? points[point].deviation_error_bounds[truth]
                                            : truths[truth].error_bounds.of(measure);
}

std::vector<std::size_t> Chart::front(ChartKind kind, ChartMeasure measure,
                                      std::size_t truth) const {
  std::vector<Cost> costs(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    costs[i] = cost_of(*this, i, kind, measure, truth);
  return pareto_front(costs);
}

std::vector<std::size_t> Chart::rivals(std::size_t point, ChartMeasure measure,
                                       std::size_t truth) const {
  const ChartKind kind = points[point].place.kind;
  const double error = cost_of(*this, point, kind, measure, truth).error.value();
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Cost other = cost_of(*this, i, kind, measure, truth);
    if (i != point && other.error && other.seconds &&
        (1 - worthwhile_gain) * *other.error <= error &&
        !points[point].is_faster_than(points[i]))
      all.push_back(i);
  }
  return all;
}

ChartErrors errors_of(const StoredChart& chart, const ChartTruth& truth,
                      const Measures& found, const Measures* compared) {
  ChartErrors errors;
  if (const auto answer = measure_of(found, chart.answer))
    errors.force = std::abs(*answer / truth.answer.value - 1);
  if (const auto volume = found.volume_change)
    errors.volume =
        std::abs(*volume - truth.volume_change.value) / (truth.imposed / chart.height);
  if (compared != nullptr) errors.deviation = compared->deviation_l2_relative;
  return errors;
}

Chart evaluated(const StoredChart& stored, const Cases& cases) {
  Chart chart{.stored = stored};
  for (const StoredChart::Truth& grids : stored.truths)
    if (auto truth = truth_of(stored, grids, cases)) chart.truths.push_back(*truth);
  std::map<std::pair<std::string, std::string>, std::string> compared;
  for (const StoredChart::Comparison& comparison : stored.comparisons)
    compared[{comparison.key, comparison.law}] = comparison.compared;
  for (const StoredChart::Point& place : stored.points) {
    ChartPoint point{
        .place = place,
        .errors = std::vector<ChartErrors>(chart.truths.size()),
        .deviation_error_bounds = std::vector<std::optional<double>>(chart.truths.size()),
        .compared = std::vector<std::string>(chart.truths.size())};
    if (const StoredCase* found = find(cases, place.key)) point.found = *found;
    for (std::size_t i = 0; point.found && i < chart.truths.size(); ++i) {
      ChartTruth& truth = chart.truths[i];
      const auto key = compared.find({place.key, truth.grids.law});
      const StoredCase* other =
          key == compared.end() ? nullptr : find(cases, key->second);
      if (other != nullptr) point.compared[i] = key->second;
      point.errors[i] = errors_of(stored, truth, point.found->measures,
                                  other == nullptr ? nullptr : &other->measures);
      if (other == nullptr) continue;
      const auto error_bound = other->measures.reference_bar_l2_relative;
      if (!error_bound) continue;
      point.deviation_error_bounds[i] =
          std::max(*error_bound, truth.grids.places_apart.value_or(0));
      truth.error_bounds.deviation = std::max(truth.error_bounds.deviation.value_or(0),
                                              *point.deviation_error_bounds[i]);
    }
    chart.points.push_back(std::move(point));
  }
  return chart;
}

}  // namespace springcheck
