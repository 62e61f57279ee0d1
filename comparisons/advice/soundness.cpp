#include "comparisons/advice/soundness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/studies/converged_number.hpp"

namespace springcheck {
namespace {

/// The first error above the tolerance as "5.2 % off in volume"; empty where there is
/// none.
std::string first_beyond(const Wish& wish, const ChartErrors& errors) {
  for (const ChartMeasure measure : wish.measures)
    if (const auto& error = errors.of(measure); error && *error > wish.tolerance)
      return fmt::format("{:.3g} % off in {}", 100 * *error, name_of(measure));
  return {};
}

/// The value that converges with the cells.
std::optional<double> value_of(const Chart& chart, std::size_t point,
                               ChartMeasure measure, std::size_t truth) {
  const Measures& measures = chart.points[point].found.value().measures;
  switch (measure) {
    case ChartMeasure::force:
      return measure_of(measures, chart.stored.answer);
    case ChartMeasure::volume:
      return measures.volume_change;
    case ChartMeasure::deviation:
      break;
  }
  return chart.points[point].errors[truth].deviation;
}

}  // namespace

std::optional<double> limit_error(const Chart& chart,
                                  std::span<const std::size_t, 3> points,
                                  ChartMeasure measure, std::size_t truth) {
  GridSizes sizes{};
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    sizes[i] = 1. / chart.points[points[i]].place.across;
    const auto value = value_of(chart, points[i], measure, truth);
    if (!value) return std::nullopt;
    values[i] = *value;
  }
  const double unit = measure == ChartMeasure::force ? std::abs(values[2]) : 1;
  const ChartTruth& of = chart.truths[truth];
  const double order_of_cells = 2;  // of springs and of linear elements
  const ConvergedNumber limit =
      converged_number(sizes, values, solver_noise * unit,
                       std::min(order_of_cells, of.grids.grids.formal_order));
  switch (measure) {
    case ChartMeasure::force:
      return std::abs(limit.value / of.answer.value - 1) +
             limit.error_bound / std::abs(of.answer.value);
    case ChartMeasure::volume:
      return (std::abs(limit.value - of.volume_change.value) + limit.error_bound) /
             (of.imposed / chart.stored.height);
    case ChartMeasure::deviation:
      break;
  }
  return std::abs(limit.value) + limit.error_bound;
}

Examiner::Examiner(const Wish& wish, BodyShape shape, Measurements& measurements,
                   Chart& chart)
    : wish_(wish), shape_(shape), measurements_(measurements), chart_(chart) {}

const Soundness& Examiner::of(std::size_t point) {
  const std::string key = chart_.points[point].place.key;
  if (!known_.contains(key)) known_[key] = examined(point);
  return known_[key];
}

Soundness Examiner::examined(std::size_t point) {
  const StoredChart::Point place = chart_.points[point].place;
  const StaticPath path =
      measurements_.static_path(chart_model(place.model, shape_), place.across);
  Soundness found{.unstable = path.against, .is_path_known = path.was_followed};
  if (!found.unstable.empty()) return found;
  found.crossing = against_law(point);
  if (found.crossing.empty()) found.crossing = against_limit(point);
  if (found.crossing.empty()) found.crossing = against_finer_cells(point, found);
  if (found.crossing.empty()) found.crossing = against_beside(point, found);
  return found;
}

bool Examiner::measure_if_within(const ChartModel& model, int across, double seconds) {
  if (point_of(model.model, across)) return true;
  if (measurements_.expected_seconds(model, across) > seconds) return false;
  measurements_.measure(model, across, seconds);
  return true;
}

std::optional<std::size_t> Examiner::point_of(const Model& model, int across) const {
  for (std::size_t i = 0; i < chart_.points.size(); ++i) {
    const ChartPoint& point = chart_.points[i];
    if (point.place.model == model && point.place.across == across &&
        point.place.threads == wish_.threads && point.found)
      return i;
  }
  return std::nullopt;
}

std::size_t Examiner::truth() const {
  return chart_.truth_of(chart_.stored.law).value();
}

/// The point on other cells; none where they take too long.
std::optional<std::size_t> Examiner::measured(std::size_t point, int across) {
  constexpr double most_times_as_long = 10;
  const StoredChart::Point place = chart_.points[point].place;
  const double most =
      std::max(wish_.budget, most_times_as_long * place.timing.value().median);
  if (!point_of(place.model, across)) {
    if (!measure_if_within(chart_model(place.model, shape_), across, most))
      return std::nullopt;
    chart_ = measurements_.chart();
  }
  return point_of(place.model, across);
}

std::string Examiner::against_law(std::size_t point) const {
  const StoredChart::Point& place = chart_.points[point].place;
  const auto law =
      measurements_.law_errors(chart_model(place.model, shape_), place.across);
  const std::string off = law ? first_beyond(wish_, *law) : "";
  return off.empty() ? "" : fmt::format("its law is {}", off);
}

/// What is against a model whose law is not known: what it converges to by the next
/// coarser and finer cells, or by two finer ones where it is not ok on coarser ones.
std::string Examiner::against_limit(std::size_t point) {
  const StoredChart::Point place = chart_.points[point].place;
  if (measurements_.law_errors(chart_model(place.model, shape_), place.across)) return {};
  std::vector<std::size_t> three{point};
  const auto next = std::ranges::upper_bound(sizes_across, place.across);
  const auto own = std::ranges::lower_bound(sizes_across, place.across);
  if (own != sizes_across.begin())
    if (const auto coarser = measured(point, *std::prev(own));
        coarser && chart_.points[*coarser].is_ok())
      three.insert(three.begin(), *coarser);
  for (auto finer = next; finer != sizes_across.end() && three.size() < 3; ++finer) {
    const auto one = measured(point, *finer);
    if (!one) break;
    if (!chart_.points[*one].is_ok())
      return fmt::format("on {} across it is {}", *finer,
                         name_of(chart_.points[*one].found->status));
    three.push_back(*one);
  }
  if (three.size() < 3) return "what it converges to is not known";
  const std::span<const std::size_t, 3> points(three);
  ChartErrors limit;
  limit.force = limit_error(chart_, points, ChartMeasure::force, truth());
  limit.volume = limit_error(chart_, points, ChartMeasure::volume, truth());
  limit.deviation = limit_error(chart_, points, ChartMeasure::deviation, truth());
  const std::string off = first_beyond(wish_, limit);
  return off.empty()
             ? ""
             : fmt::format("what it converges to may be {}, its bound included", off);
}

/// What is against a point on the next finer cells. The errors alone are judged: what the
/// truth may be off differs from mesh to mesh.
std::string Examiner::against_finer_cells(std::size_t point, Soundness& found) {
  const auto finer =
      std::ranges::upper_bound(sizes_across, chart_.points[point].place.across);
  found.is_finest = finer == sizes_across.end();
  const auto next = found.is_finest ? std::nullopt : measured(point, *finer);
  found.were_finer_cells_seen = next.has_value();
  if (!next) return {};
  const ChartPoint& there = chart_.points[*next];
  const std::string off = there.is_ok() ? first_beyond(wish_, there.errors[truth()])
                                        : std::string(name_of(there.found->status));
  return off.empty() ? "" : fmt::format("on {} across it is {}", *finer, off);
}

std::string Examiner::against_beside(std::size_t point, Soundness& found) {
  const StoredChart::Point place = chart_.points[point].place;
  const ChartModel& model = chart_model(place.model, shape_);
  for (std::size_t i = 0; i < measurements_.scenes_beside(model); ++i) {
    const BesideScene shown = measurements_.beside(i, model, place.across);
    if (!shown.has_truth) {
      found.without_truth.push_back(shown.where);
      continue;
    }
    if (shown.status != Status::ok)
      return fmt::format("{} it is {}", shown.where, name_of(shown.status));
    const std::string off = first_beyond(wish_, shown.errors);
    if (!off.empty()) return fmt::format("{} it is {}", shown.where, off);
  }
  return {};
}

}  // namespace springcheck
