#pragma once

#include <string>

#include "comparisons/chart/chart.hpp"
#include "comparisons/chart/chart_models.hpp"

namespace springcheck {

/// What following the static path of springs to the full load showed (solver limit).
struct StaticPath {
  bool was_followed = false;  // not where it would have taken more than the budget
  std::string against{};      // why it ends before the full load; empty where it does not
  double nodes = 0, seconds = 0;
};

/// Where advice gets its figures from: a chart that grows while they are asked for.
class Measurements {
 public:
  Measurements() = default;
  virtual ~Measurements() = default;
  Measurements(const Measurements&) = delete;
  Measurements& operator=(const Measurements&) = delete;

  /// [s] that a point's solution is expected to take, from smaller points of the model: 0
  /// without any, infinite where it would not fit into the memory.
  [[nodiscard]] virtual double expected_seconds(const ChartModel& model, int across) = 0;

  /// Adds the point of a model on so many cells across, if the chart lacks it.
  virtual void measure(const ChartModel& model, int across) = 0;

  /// The static path of a model's springs, on so many cells across; of finite elements it
  /// has nothing against.
  virtual StaticPath static_path(const ChartModel& model, int across) = 0;

  /// With all that was measured so far; places stay when more are.
  [[nodiscard]] virtual Chart chart() const = 0;
};

}  // namespace springcheck
