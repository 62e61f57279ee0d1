#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/chart/chart_truth.hpp"

namespace springcheck {

struct ChartPoint {
  StoredChart::Point place;
  std::optional<StoredCase> found{};  // none where it was not run
  std::vector<ChartErrors> errors;    // for each truth; none in failed cases
  std::vector<std::optional<double>>
      deviation_error_bounds;         // of each truth on this mesh
  std::vector<std::string> compared;  // keys of the cases that tell them, or ""

  /// Whether it is a state to rely on: an equilibrium, or end of a motion, with nothing
  /// against it.
  [[nodiscard]] bool is_ok() const { return found && found->status == Status::ok; }

  /// The median time of the solution [s], or the real time per simulated second.
  [[nodiscard]] std::optional<double> seconds() const;
  [[nodiscard]] std::optional<double> seconds_at(double Timing::*quantile) const;

  /// Whether its times, which both must have, are less than another's, see is_less.
  [[nodiscard]] bool is_faster_than(const ChartPoint& other) const;
};

/// The point's time as text: "0.12 s", or for a motion "0.12 s per simulated s". It must
/// have a time.
std::string time_text(const ChartPoint& point);

/// The family of the point's method: as the file tells, or else as the method's entry
/// does; empty where neither is known.
std::string family_of(const StoredChart::Point& point);

/// The status of the point's case, or why it was not timed.
std::string status_of(const ChartPoint& point);

/// A chart with its errors.
struct Chart {
  StoredChart stored;
  std::vector<ChartTruth> truths{};  // without laws that have none: a grid failed
  std::vector<ChartPoint> points{};

  /// The place of a law's truth; none where the chart has none.
  [[nodiscard]] std::optional<std::size_t> truth_of(const std::string& law) const;

  /// Whether a point is of the same elements on the same cells as one of the grids that
  /// tell a truth, whatever solved it: judged by what follows from its own figures.
  [[nodiscard]] bool tells_truth(std::size_t point, std::size_t truth) const;

  /// What the truth may be off in a measure, for a point; in deviations, on the point's
  /// mesh.
  [[nodiscard]] std::optional<double> error_bound(std::size_t point, ChartMeasure measure,
                                                  std::size_t truth) const;

  /// The front of one kind and one truth, over its points that are ok, see pareto_front;
  /// an error below what the truth may be off counts as that.
  [[nodiscard]] std::vector<std::size_t> front(ChartKind kind, ChartMeasure measure,
                                               std::size_t truth) const;

  /// What may take a point's place on that front when all is timed again: the other
  /// points of its kind that are ok, as accurate but for less than worthwhile_gain, and
  /// not told to be slower (is_faster_than). Without any, it is expected to stay.
  [[nodiscard]] std::vector<std::size_t> rivals(std::size_t point, ChartMeasure measure,
                                                std::size_t truth) const;
};

/// The errors of a case with these figures, and with those of its deviations from the
/// truth where they are known.
ChartErrors errors_of(const StoredChart& chart, const ChartTruth& truth,
                      const Measures& found, const Measures* compared);

/// Tells the errors of what a chart holds, by the figures of its cases.
Chart evaluated(const StoredChart& stored,
                const std::map<std::string, StoredCase>& cases);

}  // namespace springcheck
