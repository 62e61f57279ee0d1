#pragma once

#include <functional>
#include <map>
#include <vector>

namespace springcheck {

/// Real times of one piece of work [s], round by round: rounds lie minutes apart, in
/// which a machine's clock and its other work change more than from one repetition to the
/// next.
using TimedRounds = std::vector<std::vector<double>>;

inline constexpr int most_rounds = 3;

/// Quantiles over all repetitions, each round counting the same: a restless one repeats
/// more often. There are also the medians of the fastest and the slowest round.
struct Timing {
  int repetitions;
  double minimum, lower_quartile, median, upper_quartile, maximum;
  int rounds;
  double fastest_round, slowest_round;
};

/// Quantiles by linear interpolation between the ordered times (type 7 of Hyndman and
/// Fan, The American Statistician 50, 1996); of several rounds those of their union, each
/// by 25 quantiles of its own. There must be a round, and a time in each.
Timing timing_of(const TimedRounds& rounds);

/// What is left of the times beyond `less` [s], multiplied by a factor.
Timing scaled(Timing timing, double less, double factor);

/// Whether the times can be told to be less than others: the slowest round is faster than
/// the other's fastest, or where one has fewer than most_rounds the quartiles do not
/// overlap; and the medians differ by a fifth. Charts of an hour apart on a shared
/// machine (AMD EPYC, 43,000 pairs of points) told no pair the other way round by that,
/// by the rounds alone 11.
bool is_less(const Timing& timing, const Timing& other);

/// The time that a size is expected to take [s], from the seconds of smaller ones: that
/// of the largest of them, with the growth to it from the one before, as a power from 1
/// to 5/2; from one alone in proportion. It is 0 without any.
double expected_seconds(const std::map<double, double>& smaller, double size);

/// Times of a round of work that returns the seconds that count: one warm-up, then
/// repetitions until the median changed by no more than 2 % twice running, so three at
/// least, there are 25, or the seconds of all, those that do not count included, reach
/// the budget. The warm-up counts where it took the whole budget.
std::vector<double> timed(const std::function<double()>& work, double budget);

}  // namespace springcheck
