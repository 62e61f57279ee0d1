#pragma once

#include <functional>
#include <vector>

namespace springcheck {

/// Real times of one piece of work [s]: of its repetitions, without the warm-up unless it
/// took the whole budget.
struct Timing {
  int repetitions;
  double minimum, lower_quartile, median, upper_quartile, maximum;
};

/// Quantiles by linear interpolation between the ordered times (type 7 of Hyndman and
/// Fan, The American Statistician 50, 1996). There must be at least one.
Timing timing_of(std::vector<double> seconds);

/// What is left of the times beyond `less` [s], multiplied by a factor.
Timing scaled(Timing timing, double less, double factor);

/// Whether the times can be told to be less than others: the quartiles do not overlap,
/// and of fewer than three runs, whose quartiles tell little, the medians differ by a
/// tenth or more.
bool is_less(const Timing& timing, const Timing& other);

/// Times a piece of work that returns the seconds that count: one warm-up, then
/// repetitions until the median changed by no more than 2 % twice running, so three at
/// least, there are 25, or the seconds of all, those that do not count included, reach
/// the budget.
Timing timed(const std::function<double()>& work, double budget);

}  // namespace springcheck
