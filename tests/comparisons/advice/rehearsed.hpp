#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/advice/advise.hpp"
#include "tests/comparisons/chart/example_chart.hpp"

namespace springcheck {

/// What a model shows on so many cells across.
struct Shown {
  double seconds, percent_off;
  Status status = Status::ok;
  TimedRounds rounds{};  // [s]; none: quartiles 10 % beside the seconds
  TimedRounds again{};   // what further rounds make of them; none: the same
};

/// Figures that are made up, beside the truth of ExampleChart, 10 N +- 12.5 %, or
/// known_to. Models without any would not fit into the memory.
class Rehearsed : public Measurements {
 public:
  std::map<std::string, std::map<int, Shown>> shown;       // by model, cells across
  std::map<std::string, StaticPath> paths;                 // by model, where not stable
  std::map<std::string, BesideScene> scenes;               // by model, a scene beside
  std::map<std::string, std::optional<ChartErrors>> laws;  // by model, where not right
  std::optional<double> known_to{};                        // of the truth's force
  std::vector<std::string> measured;                       // in this order

  double expected_seconds(const ChartModel& model, int across) override {
    const Shown* found = find(model, across);
    return found ? found->seconds : std::numeric_limits<double>::infinity();
  }

  void measure(const ChartModel& model, int across, double) override {
    const std::string name = name_of(model.model) + " " + std::to_string(across);
    if (std::ranges::count(measured, name) > 0) return;
    measured.push_back(name);
    const Shown found = *find(model, across);
    example_
        .add(name_of(model.model), across, found.seconds,
             10 * (1 + found.percent_off / 100), 0.002, model.kind)
        .status = found.status;
    if (!found.rounds.empty())
      example_.chart.points.back().timing = timing_of(found.rounds);
  }

  void time_again(const ChartModel& model, int across) override {
    const Shown found = *find(model, across);
    if (found.again.empty()) return;
    for (StoredChart::Point& point : example_.chart.points)
      if (point.model == model.model && point.across == across)
        point.timing = timing_of(found.again);
  }

  StaticPath static_path(const ChartModel& model, int) override {
    const auto found = paths.find(name_of(model.model));
    return found == paths.end() ? StaticPath{.was_followed = true} : found->second;
  }

  std::optional<ChartErrors> law_errors(const ChartModel& model, int) override {
    const auto found = laws.find(name_of(model.model));
    return found == laws.end() ? ChartErrors{.force = 0} : found->second;
  }

  std::size_t scenes_beside(const ChartModel& model) override {
    return scenes.count(name_of(model.model));
  }

  BesideScene beside(std::size_t, const ChartModel& model, int) override {
    return scenes.at(name_of(model.model));
  }

  [[nodiscard]] Chart chart() const override {
    Chart chart = evaluated(example_.chart, example_.cases);
    if (known_to) chart.truths[0].error_bounds.force = known_to;
    return chart;
  }

 private:
  [[nodiscard]] const Shown* find(const ChartModel& model, int across) const {
    const auto found = shown.find(name_of(model.model));
    if (found == shown.end() || !found->second.contains(across)) return nullptr;
    return &found->second.at(across);
  }

  ExampleChart example_;
};

inline Advice advice_of(Rehearsed& rehearsed, double tolerance = 0.3,
                        const GivenSettings& changes = {}) {
  const Wish wish{.measures = {ChartMeasure::force},
                  .tolerance = tolerance,
                  .frame = std::nullopt,
                  .budget = 10,
                  .threads = 1};
  const ChartPlan plan{.scene = "compression",
                       .options = changes,
                       .laws = {},
                       .across = {},
                       .threads = {1},
                       .budget = 10,
                       .repeat_for = 1,
                       .jobs = 1,
                       .retime = false,
                       .least_models = 0};
  return advise(wish, plan, rehearsed);
}

inline std::string name_of(const Advice& advice,
                           const std::optional<std::size_t>& place) {
  if (!place) return "none";
  const StoredChart::Point& point = advice.chart.points[*place].place;
  return name_of(point.model) + " " + std::to_string(point.across);
}

}  // namespace springcheck
