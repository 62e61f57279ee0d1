#pragma once

#include <filesystem>
#include <memory>

#include "comparisons/chart/chart.hpp"
#include "comparisons/chart/chart_plan.hpp"

namespace springcheck {

/// A chart while it is measured, kept in a result file: truths, with their fields, and
/// every point as soon as it is there. What the file holds is not measured again.
///
/// Times are of the solution alone, on a mesh that is there: neither measuring it nor
/// writing counts. A point is left out where it is expected to exceed the budget, or the
/// memory that the machine has left.
///
/// Bodies that are no blocks have no deviations: their meshes are not nested.
class ChartRun {
 public:
  /// Computes the truths. Throws InputError as planned_chart.
  ChartRun(const ChartPlan& plan, const std::filesystem::path& file);
  ~ChartRun();

  /// Measures a model on so many cells across. Throws InputError where their mesh alone
  /// would not fit into the memory.
  void measure(const ChartModel& model, int across);

  /// [s] of the plan's first number of threads, by the median of the model's next smaller
  /// point and the growth from the one before to it, as a power of the nodes from 1 to
  /// 5/2; from one point alone 3/2. 0 without any.
  [[nodiscard]] double expected_seconds(const ChartModel& model, int across);

  /// With all that the file holds of the scene.
  [[nodiscard]] Chart chart() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Measures all points of the plan.
Chart make_chart(const ChartPlan& plan, const std::filesystem::path& file);

}  // namespace springcheck
