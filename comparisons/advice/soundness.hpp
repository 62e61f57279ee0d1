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
  std::vector<std::string> without_truth{};  // scenes beside that have none

  [[nodiscard]] bool is_sound() const { return unstable.empty() && crossing.empty(); }
};

/// Looks at the reasons of points of a chart, each once.
class Examiner {
 public:
  /// All must outlive it. What it measures is added to the chart.
  Examiner(const Wish& wish, BodyShape shape, Measurements& measurements, Chart& chart);

  /// Of a point that meets the wish's tolerance. It is sound where
  ///
  /// - springs reach the full load by a stable path (solver limit), as far as the budget
  ///   lets it be followed,
  /// - the model is ok on the next finer cells (the next two where it is not on coarser
  ///   ones), with no error above the tolerance,
  /// - nor are the errors of what it converges to by these three sizes, see limit_error;
  ///   elements of the truth's own law converge to it,
  /// - it is ok in the scenes beside, see Neighbour, and shown to be beyond the tolerance
  ///   in none.
  ///
  /// Finer cells and the path are looked at where the wish's budget allows.
  const Soundness& of(std::size_t point);

  /// Runs a model unless it is expected to take longer [s]; whether it did.
  bool measure_if_within(const ChartModel& model, int across, double seconds);

  /// The model's point on so many cells across; none where it was not run.
  [[nodiscard]] std::optional<std::size_t> point_of(const Model& model, int across) const;

  /// After the truth's bars have changed.
  void forget() { known_.clear(); }

 private:
  [[nodiscard]] Soundness examined(std::size_t point);
  [[nodiscard]] std::vector<std::size_t> convergence_of(std::size_t point);
  [[nodiscard]] std::string against_finer_cells(std::span<const std::size_t> finer) const;
  [[nodiscard]] std::string against_limit(std::span<const std::size_t, 3> points) const;
  [[nodiscard]] std::string against_beside(std::size_t point, Soundness& found);
  [[nodiscard]] std::size_t truth() const;

  const Wish& wish_;
  BodyShape shape_;
  Measurements& measurements_;
  Chart& chart_;
  std::map<std::string, Soundness> known_;  // by the key of the point's case
};

/// Error of what a model converges to, by its points on three sizes, from coarse to fine:
/// of force and volume by the limit of their values, of deviations by their own limit
/// (converged_number); the finest one's where these show no order. None where one lacks
/// the figure.
std::optional<double> limit_error(const Chart& chart,
                                  std::span<const std::size_t, 3> points,
                                  ChartMeasure measure, std::size_t truth);

}  // namespace springcheck
