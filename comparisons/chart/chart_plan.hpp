#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/chart/chart_models.hpp"
#include "comparisons/results/stored_chart.hpp"
#include "comparisons/settings/run_settings.hpp"
#include "comparisons/studies/study.hpp"

namespace springcheck {

/// What a chart is to measure.
struct ChartPlan {
  std::string scene;
  GivenSettings options;            // that replace the scene's
  std::string law{};                // the scene's, in place of its reference's; or none
  std::vector<std::string> laws{};  // of truths, beside that of the scene
  ChartModels models{};
  std::vector<int> across{};          // cells across the shortest edge
  std::vector<int> threads;           // of the timed runs
  double budget;                      // [s] that a point's solution may take
  double repeat_for;                  // [s] of a point's repetitions, in all rounds
  int jobs;                           // truths at once
  bool retime;                        // what the file has a time of, and nothing else
  int least_models;                   // ok on the finest at equilibrium, budget or not
  std::optional<int> truth_across{};  // of the coarsest grid, see truth_grids
  // The file that truths are kept in for other charts too, and taken from:
  std::optional<std::filesystem::path> truths_file{};
};

/// A chart of about a minute: of the foremost models on 4, 6 and 10 cells across, beside
/// the converged solution of the scene's own law alone, timed on so many threads.
ChartPlan quick_plan(const std::string& scene, int threads, int jobs);

/// The case behind a point.
CaseSettings settings_of(const ChartPlan& plan, const StoredChart::Point& point);

/// Checks a plan. Throws InputError where options do not suit one of the models, or its
/// mesh on one of the sizes would not fit into the memory; as truth_grids, too.
void check_plan(const ChartPlan& plan);

/// The grids of the plan's truths, that of the scene's law first.
std::vector<TruthGrids> planned_truths(const ChartPlan& plan);

/// What is to be said of the law of the plan's own truth, see caution_near_half.
std::string caution_of_truth(const ChartPlan& plan);

/// The chart of a plan before anything is measured. Throws InputError for scenes without
/// an answer to compare, those of traction and affine, and as chart_body.
StoredChart planned_chart(const ChartPlan& plan, const std::vector<TruthGrids>& truths,
                          MeshStore& meshes);

}  // namespace springcheck
