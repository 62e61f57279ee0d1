#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/advice/measurements.hpp"
#include "comparisons/advice/neighbours.hpp"
#include "comparisons/chart/chart_run.hpp"

namespace springcheck {

/// Measurements that a chart in a result file keeps, with the cases beside it.
class ChartMeasurements : public Measurements {
 public:
  /// Computes the truth. Throws InputError as ChartRun, and std::runtime_error where the
  /// law has none.
  ChartMeasurements(const ChartPlan& plan, const std::filesystem::path& file);

  [[nodiscard]] double expected_seconds(const ChartModel& model, int across) override {
    return run_.expected_seconds(model, across);
  }
  void measure(const ChartModel& model, int across, double seconds) override;
  void time_again(const ChartModel& model, int across) override;

  /// Follows the path on 2 cells across and up, as long as the next size is expected to
  /// stay within the plan's budget: it takes the time of the size before, times the ratio
  /// of their nodes to the power 3/2.
  StaticPath static_path(const ChartModel& model, int across) override;

  /// The errors of q2 by the model's law, or by the continuum of its lattice, against q2
  /// by the truth's law, both on the second of the truth's three grids. Their difference
  /// has next to nothing of the grid's error, and is that of what they converge to. There
  /// are none for springs without such a continuum, for elements that step, and where q2
  /// has no equilibrium.
  std::optional<ChartErrors> law_errors(const ChartModel& model, int across) override;

  /// The number of scenes beside. Those with another Poisson's ratio are there only for
  /// models that have any (own_poisson_ratio).
  [[nodiscard]] std::size_t scenes_beside(const ChartModel& model) override;

  /// What the model shows in the scene, against the truth that carried_truth gives.
  BesideScene beside(std::size_t scene, const ChartModel& model, int across) override;

  [[nodiscard]] Chart chart() const override { return run_.chart(); }

 private:
  /// What is known of a neighbouring scene as soon as it was asked for.
  struct Known {
    Neighbour neighbour;
    bool was_asked_for = false;
    std::optional<CaseSettings> grid{};  // the truth's second one
    TwoGrids figures{};
    std::optional<double> imposed{};  // [m] there; none in bending
    // Results of points, by their settings:
    std::map<std::string, std::pair<Status, Measures>> results{};
    bool has_truth = false;
  };
  void find_truth_of(Known& scene);
  [[nodiscard]] ChartTruth truth_of(const Known& scene);

  /// The deviation that the second of the truth's grids is off by; none for bodies whose
  /// meshes are not nested.
  const std::optional<double>& deviation_of_grid();

  ChartPlan plan_;
  ChartRun run_;
  std::array<Measures, 3> figures_{};  // of the grids of the scene's own truth
  ChartTruth own_truth_{};
  MeshStore meshes_;
  int finest_across_ = 0;                    // of what was measured
  std::map<std::string, StaticPath> paths_;  // by settings
  std::vector<Known> beside_;
  std::map<std::string, std::optional<ChartErrors>> law_errors_;  // by settings
  std::optional<std::optional<double>> deviation_of_grid_;        // none: not known yet
};

}  // namespace springcheck
