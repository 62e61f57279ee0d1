#include "comparisons/advice/soundness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/studies/converged_number.hpp"

namespace springcheck {
namespace {

/// "5.2 % off in volume" of the first error above the tolerance; empty without.
std::string beyond(const Wish& wish, const ChartErrors& errors) {
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
  const double limit = converged_number(sizes, values, solver_noise * unit).value;
  const ChartTruth& of = chart.truths[truth];
  switch (measure) {
    case ChartMeasure::force:
      return std::abs(limit / of.answer.value - 1);
    case ChartMeasure::volume:
      return std::abs(limit - of.volume_change.value) /
             (of.imposed / chart.stored.height);
    case ChartMeasure::deviation:
      break;
  }
  return std::abs(limit);
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
  const std::vector<std::size_t> sizes = convergence_of(point);
  const auto own = std::ranges::find(sizes, point);
  found.were_finer_cells_seen = sizes.size() == 3 && point != sizes.back();
  found.crossing = against_finer_cells({std::next(own), sizes.end()});
  if (found.crossing.empty() && sizes.size() == 3)
    found.crossing = against_limit(std::span<const std::size_t, 3>(sizes));
  if (found.crossing.empty()) found.crossing = against_beside(point, found);
  return found;
}

bool Examiner::measure_if_within(const ChartModel& model, int across, double seconds) {
  if (measurements_.expected_seconds(model, across) > seconds) return false;
  measurements_.measure(model, across);
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

/// The model's points on three sizes with the own one: the next coarser and finer ones,
/// without a coarser one that is ok two finer ones, and two coarser ones where the budget
/// allows no finer one; fewer where there are none of these.
std::vector<std::size_t> Examiner::convergence_of(std::size_t point) {
  const StoredChart::Point place = chart_.points[point].place;
  const ChartModel& model = chart_model(place.model, shape_);
  const auto own = std::ranges::find(sizes_across, place.across);
  std::vector<std::size_t> three{point}, coarser;
  for (auto size = own; size != sizes_across.begin() && coarser.size() < 2;) {
    const auto one = point_of(place.model, *--size);
    if (!one || !chart_.points[*one].is_ok()) break;
    coarser.push_back(*one);
  }
  const auto add_coarser = [&](std::size_t most) {
    for (const std::size_t one : coarser)
      if (three.size() < most && std::ranges::count(three, one) == 0)
        three.insert(three.begin(), one);
  };
  add_coarser(2);
  for (auto finer = std::next(own); finer != sizes_across.end() && three.size() < 3;
       ++finer) {
    if (!point_of(place.model, *finer)) {
      if (!measure_if_within(model, *finer, wish_.budget)) break;
      chart_ = measurements_.chart();
    }
    const auto next = point_of(place.model, *finer);
    if (!next) break;
    three.push_back(*next);
  }
  add_coarser(3);
  return three;
}

/// By the errors alone: what the truth may be off differs from mesh to mesh.
std::string Examiner::against_finer_cells(std::span<const std::size_t> finer) const {
  for (const std::size_t i : finer) {
    const ChartPoint& point = chart_.points[i];
    const std::string off = point.is_ok() ? beyond(wish_, point.errors[truth()])
                                          : std::string(name_of(point.found->status));
    if (!off.empty())
      return fmt::format("on {} across it is {}", point.place.across, off);
  }
  return {};
}

/// Elements of the truth's own law converge to it.
std::string Examiner::against_limit(std::span<const std::size_t, 3> points) const {
  if (chart_.points[points[0]].place.model.method == chart_.stored.law) return {};
  ChartErrors limit;
  limit.force = limit_error(chart_, points, ChartMeasure::force, truth());
  limit.volume = limit_error(chart_, points, ChartMeasure::volume, truth());
  limit.deviation = limit_error(chart_, points, ChartMeasure::deviation, truth());
  const std::string off = beyond(wish_, limit);
  return off.empty() ? "" : fmt::format("finer cells lead it to what is {}", off);
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
    const std::string off = beyond(wish_, shown.errors);
    if (!off.empty()) return fmt::format("{} it is {}", shown.where, off);
  }
  return {};
}

}  // namespace springcheck
