#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/chart/chart.hpp"
#include "comparisons/chart/chart_models.hpp"

namespace springcheck {

/// What following the static path to the full load showed (solver limit).
struct StaticPath {
  bool was_followed = false;  // not where it would have taken more than the budget
  std::string against{};      // why it ends before the full load; empty where it does not
  double nodes = 0, seconds = 0;
};

/// What a model shows in a scene beside the wished one.
struct BesideScene {
  std::string where;       // "at 0.8 times the load"
  bool has_truth = false;  // no: nothing else is known
  Status status{};         // of the model there
  ChartErrors errors{};    // beyond what the truth there may be off
};

/// The source of the figures that advice is made of: a chart that grows while they are
/// asked for.
class Measurements {
 public:
  Measurements() = default;
  virtual ~Measurements() = default;
  Measurements(const Measurements&) = delete;
  Measurements& operator=(const Measurements&) = delete;

  /// The time that a point's solution is expected to take [s], from smaller points of the
  /// model: 0 without any, infinite where it would not fit into the memory.
  [[nodiscard]] virtual double expected_seconds(const ChartModel& model, int across) = 0;

  /// Adds the point of a model on so many cells across, if the chart lacks it and it is
  /// not expected to take longer [s].
  virtual void measure(const ChartModel& model, int across, double seconds) = 0;

  /// Times a point that was measured in further rounds, where it is quick, up to
  /// most_rounds in all: a single restless time decides nothing, not even one from a
  /// file.
  virtual void time_again(const ChartModel& model, int across) = 0;

  /// The static path of a model, on so many cells across; there is nothing against one
  /// that never rests.
  virtual StaticPath static_path(const ChartModel& model, int across) = 0;

  /// Errors of what the model converges to, where its law is known; none where not.
  virtual std::optional<ChartErrors> law_errors(const ChartModel& model, int across) = 0;

  /// The number of scenes beside, see Neighbour, and what the model shows in one of them.
  [[nodiscard]] virtual std::size_t scenes_beside(const ChartModel& model) = 0;
  virtual BesideScene beside(std::size_t scene, const ChartModel& model, int across) = 0;

  /// The chart with all that was measured so far; the places of its points stay when more
  /// are measured.
  [[nodiscard]] virtual Chart chart() const = 0;
};

}  // namespace springcheck
