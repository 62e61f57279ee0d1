#include "comparisons/advice/wish.hpp"

#include <algorithm>
#include <cmath>

namespace springcheck {
namespace {

constexpr double step_ratio = 0.9;

}  // namespace

std::optional<Frame> frame_of(const ChartPoint& point, double duration) {
  if (!point.found || !point.found->dt_limit || !point.place.timing) return std::nullopt;
  const int all_steps = point.found->effort.value_or(Effort{}).steps;
  if (all_steps == 0) return std::nullopt;
  const double steps =
      std::max(1., std::ceil(duration / (step_ratio * *point.found->dt_limit)));
  return Frame{.steps = steps,
               .dt = duration / steps,
               .timing = scaled(*point.place.timing, point.place.setup.value_or(0),
                                steps / all_steps)};
}

Judge::Judge(const Wish& wish, const Chart& chart)
    : wish_(wish), chart_(chart), truth_(chart.truth_of(chart.stored.law).value()) {}

bool Judge::is_candidate(std::size_t point) const {
  const ChartPoint& of = chart_.points[point];
  return of.place.kind == wish_.kind() && of.is_ok() && of.seconds() &&
         of.place.threads == wish_.threads &&
         std::ranges::all_of(wish_.measures,
                             [&](ChartMeasure measure) {
                               return of.errors[truth_].of(measure) &&
                                      chart_.error_bound(point, measure, truth_);
                             }) &&
         (!wish_.frame || frame_of(of, *wish_.frame));
}

double Judge::off(std::size_t point) const {
  double largest = 0;
  for (const ChartMeasure measure : wish_.measures)
    largest = std::max(largest, chart_.points[point].errors[truth_].of(measure).value());
  return largest;
}

double Judge::error(std::size_t point) const {
  double largest = 0;
  for (const ChartMeasure measure : wish_.measures)
    largest = std::max(largest, *chart_.points[point].errors[truth_].of(measure) +
                                    chart_.error_bound(point, measure, truth_).value());
  return largest;
}

Proof Judge::proof(std::size_t point) const {
  if (error(point) <= wish_.tolerance) return Proof::within;
  const bool is_beyond = std::ranges::any_of(wish_.measures, [&](ChartMeasure measure) {
    return *chart_.points[point].errors[truth_].of(measure) -
               *chart_.error_bound(point, measure, truth_) >
           wish_.tolerance;
  });
  return is_beyond ? Proof::beyond : Proof::open;
}

bool Judge::meets_tolerance(std::size_t point) const {
  return is_candidate(point) && proof(point) == Proof::within;
}

std::optional<double> Judge::cost(std::size_t point) const {
  const ChartPoint& of = chart_.points[point];
  if (!wish_.frame) return of.seconds();
  const auto frame = frame_of(of, *wish_.frame);
  return frame ? std::optional(frame->seconds() / *wish_.frame) : std::nullopt;
}

bool Judge::is_cheaper(std::size_t point, std::size_t other) const {
  const ChartPoint &one = chart_.points[point], &another = chart_.points[other];
  if (!wish_.frame) return one.is_faster_than(another);
  return is_less(frame_of(one, *wish_.frame).value().timing,
                 frame_of(another, *wish_.frame).value().timing);
}

double Judge::missed_cost(std::size_t point) const {
  const double frame = wish_.frame ? *cost(point) : 0;
  return std::max(frame, chart_.points[point].place.timing->median / wish_.budget);
}

bool Judge::is_affordable(std::size_t point) const {
  return missed_cost(point) <= 1;
}

bool Judge::meets(std::size_t point) const {
  return meets_tolerance(point) && is_affordable(point);
}

double Judge::distance(std::size_t point) const {
  return std::max(error(point) / wish_.tolerance, missed_cost(point));
}

}  // namespace springcheck
