#include "comparisons/chart/timing.hpp"

#include <algorithm>
#include <cmath>

#include "meshing/stopwatch.hpp"

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

}  // namespace

Timing timing_of(std::vector<double> seconds) {
  std::ranges::sort(seconds);
  return {.repetitions = static_cast<int>(seconds.size()),
          .minimum = seconds.front(),
          .lower_quartile = quantile(seconds, 0.25),
          .median = quantile(seconds, 0.5),
          .upper_quartile = quantile(seconds, 0.75),
          .maximum = seconds.back()};
}

Timing scaled(Timing timing, double less, double factor) {
  for (double Timing::*seconds :
       {&Timing::minimum, &Timing::lower_quartile, &Timing::median,
        &Timing::upper_quartile, &Timing::maximum})
    timing.*seconds = (timing.*seconds - less) * factor;
  return timing;
}

bool is_less(const Timing& timing, const Timing& other) {
  constexpr int enough = 3;
  constexpr double unrepeated_spread = 0.1;
  const bool is_repeated = std::min(timing.repetitions, other.repetitions) >= enough;
  return timing.upper_quartile < other.lower_quartile &&
         (is_repeated || timing.median < (1 - unrepeated_spread) * other.median);
}

Timing timed(const std::function<double()>& work, double budget) {
  const Stopwatch stopwatch;
  const double warm_up = work();
  if (stopwatch.seconds() >= budget) return timing_of({warm_up});
  std::vector<double> seconds;
  int quiet = 0;
  double last = 0;
  do {
    seconds.push_back(work());
    const double median = timing_of(seconds).median;
    quiet = std::abs(median - last) <= little_change * median ? quiet + 1 : 0;
    last = median;
  } while (quiet < quiet_times && seconds.size() < most && stopwatch.seconds() < budget);
  return timing_of(seconds);
}

}  // namespace springcheck
