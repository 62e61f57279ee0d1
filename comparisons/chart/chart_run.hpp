#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comparisons/chart/chart.hpp"
#include "comparisons/chart/chart_models.hpp"
#include "comparisons/chart/chart_plan.hpp"
#include "comparisons/chart/kept_truths.hpp"
#include "comparisons/results/known_results.hpp"
#include "comparisons/results/result_file.hpp"

namespace springcheck {

/// A chart while it is measured, kept in a result file: truths, with their fields, and
/// every point as soon as it is there. What the file holds is not measured again.
///
/// Times are of the solution alone, on a mesh that is there: neither measuring it nor
/// writing counts. A point is left out where it is expected to exceed the budget, unless
/// the file has a time of it, or the memory that the machine has left.
///
/// Bodies that are no blocks have no deviations: their meshes are not nested.
class ChartRun {
 public:
  /// Computes the truths. Throws InputError as planned_chart, and for a file with cases
  /// of another revision of the numerics.
  ChartRun(const ChartPlan& plan, const std::filesystem::path& file);

  /// Measures a model on so many cells across, unless it is expected to take longer [s].
  /// Throws InputError where their mesh alone would not fit into the memory.
  void measure(const ChartModel& model, int across, double seconds);

  /// Measures models until the plan's least number of them at equilibrium is timed, and
  /// ok, on the finest of its sizes, on the first of its numbers of threads. The model
  /// that is expected to be the fastest there gets its next size, budget or not, unless
  /// it fails or the finest would not fit into the memory. Linear solvers make no model
  /// of their own.
  void measure_beyond_budget(std::span<const ChartModel> models);

  /// Times the model's points in this further round, where they were measured, took no
  /// longer than the plan's repeat_for and have not had so many rounds.
  void time_again(const ChartModel& model, int across, int round);

  /// The expected time on the plan's first number of threads [s]: the median of the
  /// model's next smaller point that did not fail, if there is one, with the growth from
  /// the one before to it, as a power of the nodes from 1 to 5/2; from one point alone
  /// the power is 1. It is 0 without any point, infinite beyond the memory that is left.
  [[nodiscard]] double expected_seconds(const ChartModel& model, int across);

  /// What was measured, without errors.
  [[nodiscard]] const StoredChart& stored() const { return chart_; }

  /// The grids of q2 of the truth of the scene's own law.
  [[nodiscard]] const ThreeCases& own_truth() const {
    return truths_planned_.front().grids;
  }

  /// Runs cases that others are held against, as those of truths, and keeps them with
  /// their fields.
  void find_references(const std::vector<CaseSettings>& cases);

  /// The result from the file, or else computed and kept there without its fields.
  CaseResult result_of(const Request& request);

  /// The chart with all that the file holds of the scene.
  [[nodiscard]] Chart chart() const;

 private:
  void measure(const ChartModel& model, int across, std::span<const int> on_threads,
               double budget);
  void begin_chart();
  void find_truths();
  /// Whether the model is timed on the plan's first number of threads.
  bool is_timed(const ChartModel& model, int across);
  bool is_ok(const ChartModel& model, int across);
  bool fails_somewhere(const ChartModel& model);
  /// The first of the plan's sizes on which the model is not timed.
  std::optional<int> next_size(const ChartModel& model);
  std::string key_of(const CaseSettings& settings);
  void put(std::span<const CaseResult> results, bool with_fields);
  void know(const std::string& key, const auto& result);
  [[nodiscard]] bool is_known(const std::string& key) const;
  [[nodiscard]] bool has_failed(const std::string& key) const;
  StoredChart::Point& point_of(const ChartModel& model, const CaseSettings& settings,
                               int across, const std::string& key, int threads);
  [[nodiscard]] double seconds_of_round() const;
  [[nodiscard]] CaseSettings settings_of(const ChartModel& model, int across) const;
  [[nodiscard]] double expected_seconds(const ChartModel& model, double nodes,
                                        int threads) const;
  [[nodiscard]] bool is_compared(const std::string& compared) const;
  /// Adds the case and its deviations from every truth to the file.
  void compare(const CaseSettings& settings, const std::string& key,
               const std::optional<CaseResult>& result);

  /// What became of a case.
  struct Outcome {
    bool has_state, is_ok;
  };

  ChartPlan plan_;
  std::filesystem::path path_;
  ResultFile file_;
  StoredCases stored_;                       // of the file, before
  std::map<std::string, Outcome> outcomes_;  // by the keys of the file's cases
  MeshStore meshes_;
  std::vector<TruthGrids> truths_planned_;        // of each law
  std::map<std::string, CaseResult> references_;  // with their fields, by keys
  std::optional<KeptTruths> kept_;
  StoredChart chart_{};
};

/// Measures all points of the plan, in most_rounds rounds, and those beyond its budget
/// that its least number of models takes. Throws InputError as ChartRun
/// and check_plan.
Chart make_chart(const ChartPlan& plan, const std::filesystem::path& file);

}  // namespace springcheck
