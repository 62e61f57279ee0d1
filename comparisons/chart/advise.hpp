#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/chart/chart_run.hpp"

namespace springcheck {

/// What a user wants of a simulation.
struct Wish {
  ChartMeasure measure;
  double tolerance;  // of its error
  // [s] of a frame that must be simulated in as much real time; none: an equilibrium is
  // wanted.
  std::optional<double> frame;
};

/// A frame of motion: whole steps of at most .9 of the stability limit.
struct Frame {
  int steps;
  double dt;       // [s]
  double seconds;  // real
};

/// Of a motion's point, by its median without set-up. None without a limit.
std::optional<Frame> frame_of(const ChartPoint& point, double duration);

/// A recommended point and its neighbours, places in a chart.
struct Advice {
  Chart chart;
  std::size_t truth;                   // of the scene's law
  std::optional<std::size_t> chosen;   // none: nothing meets the wish ...
  std::optional<std::size_t> nearest;  // ... and this comes closest
  std::optional<std::size_t> cheaper;  // most accurate of the cheaper ones
  std::optional<std::size_t> dearer;   // cheapest of the more accurate ones
  std::vector<std::string> left_out;   // in words: what the chosen one does without
  std::vector<std::string> cautions;
};

/// Error and what the truth may be off, together: what is held against the tolerance.
std::optional<double> error_with_bar(const Advice& advice, std::size_t point,
                                     ChartMeasure measure);

/// The cheapest model that meets the wish: every model is run on finer and finer cells
/// until it meets the tolerance, its error no longer falls, it fails, or it would cost
/// more than what has met it (or than the plan's budget) by the growth of chart points.
/// Of points whose times' quartiles overlap that of the fewest nodes is taken. Springs
/// count only where the static path to the full load stays stable (solver limit); states
/// that a detector calls wrinkled, inverted or indefinite never do.
Advice advise(const Wish& wish, const ChartPlan& plan, ChartRun& run);

}  // namespace springcheck
