#pragma once

#include <optional>
#include <vector>

#include "comparisons/chart/chart.hpp"

namespace springcheck {

/// What a user wants of a simulation.
struct Wish {
  std::vector<ChartMeasure> measures;  // whose errors count
  double tolerance;                    // of each
  // Length of a frame that must be simulated in as much real time [s]; none: an
  // equilibrium is wanted.
  std::optional<double> frame{};
  double budget;  // [s] that a solution may take
  int threads;    // of the points that count

  [[nodiscard]] ChartKind kind() const {
    return frame ? ChartKind::motion : ChartKind::equilibrium;
  }
};

/// A frame of motion: whole steps of at most .9 of the stability limit.
struct Frame {
  double steps;   // a whole number, which may be beyond those of int
  double dt;      // [s]
  Timing timing;  // [s] real

  /// The real time of the frame by the upper quartile of whole runs [s], so that most
  /// runs hold what it says.
  [[nodiscard]] double seconds() const { return timing.upper_quartile; }
};

/// The frame of a motion's point, by its times without set-up; none without a stability
/// limit.
std::optional<Frame> frame_of(const ChartPoint& point, double duration);

/// What can be shown of a point beside a tolerance, where its truth is known to an error
/// bound.
enum class Proof { within, open, beyond };

/// The points of a chart, by their places, as a wish judges them.
class Judge {
 public:
  /// Both arguments must outlive the judge, and the chart must have the truth of its own
  /// law.
  Judge(const Wish& wish, const Chart& chart);

  /// Whether it is of the wish's kind, ok, timed and has the errors that are asked for.
  [[nodiscard]] bool is_candidate(std::size_t point) const;

  /// The largest of a candidate's errors, and of them with what the truth may be off:
  /// what is held against the tolerance.
  [[nodiscard]] double off(std::size_t point) const;
  [[nodiscard]] double error(std::size_t point) const;

  /// What can be shown of a candidate. Within: no error and error bound exceed the
  /// tolerance together. Beyond: an error exceeds it by more than its error bound.
  [[nodiscard]] Proof proof(std::size_t point) const;
  [[nodiscard]] bool meets_tolerance(std::size_t point) const;

  /// The time that a solution takes [s], or the real time per simulated time.
  [[nodiscard]] std::optional<double> cost(std::size_t point) const;

  /// Whether a candidate costs less than another, as far as times can tell.
  [[nodiscard]] bool is_cheaper(std::size_t point, std::size_t other) const;

  /// Whether a candidate keeps to budget and frame.
  [[nodiscard]] bool is_affordable(std::size_t point) const;

  /// Whether a candidate keeps to tolerance, budget and frame.
  [[nodiscard]] bool meets(std::size_t point) const;

  /// How far a candidate is from the wish: the largest of the factors that it misses
  /// tolerance, frame and budget by.
  [[nodiscard]] double distance(std::size_t point) const;

 private:
  [[nodiscard]] double missed_cost(std::size_t point) const;

  const Wish& wish_;
  const Chart& chart_;
  std::size_t truth_;
};

}  // namespace springcheck
