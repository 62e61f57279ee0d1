#include "comparisons/running/timing.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "meshing/basics/stopwatch.hpp"

namespace springcheck {
namespace {

constexpr std::size_t most = 25;
constexpr double little_change = 0.02;
constexpr int quiet_times = 2;

double quantile(const std::vector<double>& ordered, double fraction) {
  const double place = fraction * static_cast<double>(ordered.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, ordered.size() - 1);
  return std::lerp(ordered[below], ordered[above], place - std::floor(place));
}

double median_of(std::vector<double> seconds) {
  std::ranges::sort(seconds);
  return quantile(seconds, 0.5);
}

}  // namespace

Timing timing_of(const TimedRounds& rounds) {
  std::size_t repetitions = 0;
  std::vector<double> all, medians;  // all: as many quantiles of each round
  for (std::vector<double> round : rounds) {
    std::ranges::sort(round);
    repetitions += round.size();
    medians.push_back(quantile(round, 0.5));
    for (std::size_t i = 0; i < most; ++i)
      all.push_back(quantile(round, static_cast<double>(i) / (most - 1)));
  }
  std::ranges::sort(all);
  const auto [fastest, slowest] = std::ranges::minmax(medians);
  return {.repetitions = static_cast<int>(repetitions),
          .minimum = all.front(),
          .lower_quartile = quantile(all, 0.25),
          .median = quantile(all, 0.5),
          .upper_quartile = quantile(all, 0.75),
          .maximum = all.back(),
          .rounds = static_cast<int>(rounds.size()),
          .fastest_round = fastest,
          .slowest_round = slowest};
}

Timing scaled(Timing timing, double less, double factor) {
  for (double Timing::*seconds :
       {&Timing::minimum, &Timing::lower_quartile, &Timing::median,
        &Timing::upper_quartile, &Timing::maximum, &Timing::fastest_round,
        &Timing::slowest_round})
    timing.*seconds = (timing.*seconds - less) * factor;
  return timing;
}

bool is_less(const Timing& timing, const Timing& other) {
  constexpr double spread_of_machines = 0.2;
  const bool is_apart = std::min(timing.rounds, other.rounds) >= most_rounds
                            ? timing.slowest_round < other.fastest_round
                            : timing.upper_quartile < other.lower_quartile;
  return is_apart && timing.median < (1 - spread_of_machines) * other.median;
}

double expected_seconds(const std::map<double, double>& smaller, double size) {
  if (smaller.empty()) return 0;
  const auto& [last, seconds] = *smaller.rbegin();
  double exponent = 1;
  if (smaller.size() > 1) {
    const auto& [before, less] = *std::next(smaller.rbegin());
    exponent = std::clamp(std::log(seconds / less) / std::log(last / before), 1., 2.5);
  }
  return seconds * std::pow(size / last, exponent);
}

std::vector<double> timed(const std::function<double()>& work, double budget) {
  const Stopwatch stopwatch;
  const double warm_up = work();
  if (stopwatch.seconds() >= budget) return {warm_up};
  std::vector<double> seconds;
  int quiet = 0;
  double last = 0;
  do {
    seconds.push_back(work());
    const double median = median_of(seconds);
    quiet = std::abs(median - last) <= little_change * median ? quiet + 1 : 0;
    last = median;
  } while (quiet < quiet_times && seconds.size() < most && stopwatch.seconds() < budget);
  return seconds;
}

}  // namespace springcheck
