#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/advice/measurements.hpp"
#include "comparisons/advice/neighbours.hpp"
#include "comparisons/chart/chart_run.hpp"

namespace springcheck {

/// Measurements that a chart in a result file keeps, with the cases beside it.
class ChartMeasurements : public Measurements {
 public:
  /// Computes the truth. Throws InputError as ChartRun.
  ChartMeasurements(const ChartPlan& plan, const std::filesystem::path& file);

  [[nodiscard]] double expected_seconds(const ChartModel& model, int across) override {
    return run_.expected_seconds(model, across);
  }
  void measure(const ChartModel& model, int across) override;

  /// Followed on 2 cells across and up, as long as the next size is expected to stay
  /// within the plan's budget: by the time of the one before, times the nodes to 3/2.
  StaticPath static_path(const ChartModel& model, int across) override;

  /// Those beside in Poisson's ratio only for models that have any (own_poisson_ratio).
  [[nodiscard]] std::size_t scenes_beside(const ChartModel& model) override;

  /// By carried_truth from the second of the truth's three grids.
  BesideScene beside(std::size_t scene, const ChartModel& model, int across) override;

  /// By q2 on half as many cells across as the coarsest grid, see bar_by_fourth_grid: of
  /// blocks whose coarsest grid has an even number of cells along each axis.
  bool refine_truth() override;

  [[nodiscard]] Chart chart() const override;

 private:
  /// What is known of a neighbouring scene as soon as it was asked for.
  struct Known {
    Neighbour neighbour;
    bool was_asked_for = false;
    CaseSettings grid{};                // q2 there
    std::optional<ChartTruth> truth{};  // none: q2 has no equilibrium there
  };
  void find_truth_of(Known& scene);
  /// What the second of the truth's grids is off in deviation; none of bodies whose
  /// meshes are not nested.
  std::optional<double> deviation_of_grid();

  ChartPlan plan_;
  ChartRun run_;
  MeshStore meshes_;
  int finest_across_ = 0;                    // of what was measured
  std::map<std::string, StaticPath> paths_;  // by settings
  std::vector<Known> beside_;
  ChartErrors refined_bars_{};  // of the truth of the scene's law; none before
};

}  // namespace springcheck
