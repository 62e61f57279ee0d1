#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "comparisons/chart/chart.hpp"

namespace springcheck {

/// What a chart is to measure.
struct ChartPlan {
  std::string scene;
  std::vector<GivenSetting> options;  // that replace the scene's
  std::vector<std::string> laws;      // of truths, beside that of the scene
  std::vector<int> across;            // cells across the shortest edge
  std::vector<int> threads;           // of the timed runs
  double budget;                      // [s] that a point's solution may take
  double repeat_for;                  // [s] of a point's repetitions, see timed
  int jobs;                           // truths at once
  bool retime;                        // what the file has a time of
  std::optional<int> truth_across{};  // of the coarsest grid, see truth_grids
};

/// A chart while it is measured, kept in a result file: truths, with their fields, and
/// every point as soon as it is there. What the file holds is not measured again.
///
/// Times are of the solution alone, on a mesh that is there: neither measuring it nor
/// writing counts. A point is not run where the model's next smaller one, times the ratio
/// of their nodes to the power 3/2, exceeds the budget.
///
/// Bodies that are no blocks have no deviations: their meshes are not nested.
class ChartRun {
 public:
  /// Computes the truths. Throws InputError for scenes without an answer to compare,
  /// those of traction and affine, and as chart_body.
  ChartRun(const ChartPlan& plan, const std::filesystem::path& file);
  ~ChartRun();

  /// Measures a model on so many cells across.
  void measure(const ChartModel& model, int across);

  /// [s] that the model's next smaller point lets expect, by the median of the plan's
  /// first number of threads; 0 without one.
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
