#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comparisons/advice/measurements.hpp"
#include "comparisons/advice/wish.hpp"

namespace springcheck {

/// Cells across that advice tries.
inline constexpr std::array sizes_across{2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32};

/// Whether a point that meets a wish does so for a reason.
struct Soundness {
  std::string unstable{};  // why its path ends before the full load; empty where not
  std::string crossing{};  // what else is against it, with figures; empty: nothing
  bool is_path_known = true;
  bool were_finer_cells_seen = true;
  bool is_finest = false;                    // of the sizes that are tried
  std::vector<std::string> without_truth{};  // scenes beside that have none

  [[nodiscard]] bool is_sound() const { return unstable.empty() && crossing.empty(); }
};

/// Looks at the reasons of points of a chart, each once.
class Examiner {
 public:
  /// All arguments must outlive it. What it measures is added to the chart.
  Examiner(const Wish& wish, BodyShape shape, Measurements& measurements, Chart& chart);

  /// The soundness of a candidate of the wish (Judge). It is sound where
  ///
  /// - it reaches the full load by a stable path (solver limit), as far as the budget
  ///   lets it be followed,
  /// - no error of what the model converges to exceeds the tolerance: that of its law
  ///   (Measurements::law_errors) or, where that is not known, error and error bound
  ///   together by three sizes, which must be known (limit_error),
  /// - the model is ok on the next finer cells, with no error above the tolerance,
  /// - it is ok in the scenes beside, see Neighbour, and shown to be beyond the tolerance
  ///   in none.
  ///
  /// Finer cells are looked at where they take at most ten times the point's own seconds,
  /// or the budget.
  const Soundness& of(std::size_t point);

  /// Runs a model unless it is expected to take longer [s]. Returns whether it was run,
  /// now or before.
  bool measure_if_within(const ChartModel& model, int across, double seconds);

  /// What is against the law of a point's model; empty where nothing is, or where its law
  /// is not known.
  [[nodiscard]] std::string against_law(std::size_t point) const;

  /// The model's point on so many cells across; none where it was not run.
  [[nodiscard]] std::optional<std::size_t> point_of(const Model& model, int across) const;

 private:
  [[nodiscard]] Soundness examined(std::size_t point);
  [[nodiscard]] std::string against_limit(std::size_t point);
  [[nodiscard]] std::string against_finer_cells(std::size_t point, Soundness& found);
  [[nodiscard]] std::optional<std::size_t> measured(std::size_t point, int across);
  [[nodiscard]] std::string against_beside(std::size_t point, Soundness& found);
  [[nodiscard]] std::size_t truth() const;

  const Wish& wish_;
  BodyShape shape_;
  Measurements& measurements_;
  Chart& chart_;
  std::map<std::string, Soundness> known_;  // by the key of the point's case
};

/// Error of what a model converges to, by its points on three sizes, from coarse to fine,
/// with its error bound: that of force and volume by the limit of their values, that of
/// deviations by their own limit (converged_number). None where a point lacks the figure.
std::optional<double> limit_error(const Chart& chart,
                                  std::span<const std::size_t, 3> points,
                                  ChartMeasure measure, std::size_t truth);

}  // namespace springcheck
