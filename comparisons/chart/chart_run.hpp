#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "comparisons/chart/chart.hpp"

namespace springcheck {

/// What a chart is to measure.
struct ChartPlan {
  std::string scene;
  std::vector<GivenSetting> options;  // that replace the scene's
  std::vector<int> across;            // cells across the shortest edge
  std::vector<int> threads;           // of the timed runs
  double budget;                      // [s] for each point
  int jobs;                           // truths at once
  bool retime;                        // what the file has a time of
  std::optional<int> truth_across{};  // of the coarsest grid, see truth_case
};

/// Measures what the result file lacks of the plan's points and returns the file's chart
/// of the scene, other points included. Truths come first, with their fields; every point
/// is in the file as soon as it is measured.
///
/// Times are of the solution alone, on a mesh that is there: neither measuring it nor
/// writing counts. A point is not run where the model's next smaller one, times the ratio
/// of their nodes to the power 3/2, exceeds the budget.
///
/// Throws InputError for scenes without an answer to compare: those of traction and
/// affine, bodies that are no blocks.
Chart make_chart(const ChartPlan& plan, const std::filesystem::path& file);

}  // namespace springcheck
