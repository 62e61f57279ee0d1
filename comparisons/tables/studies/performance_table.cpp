#include "comparisons/tables/studies/performance_table.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <map>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/running/stepping.hpp"
#include "comparisons/system/environment.hpp"

namespace springcheck {
namespace {

/// A scene of the thesis's performance study: how many steps its figure shows, and a time
/// it prints for mss-cf on some body.
struct TimedScene {
  const char* name;
  const char* figures;
  SteppedLoad load;
  double poisson_ratio;  // one at which mss-cf has corrections to compute
  std::vector<std::array<int, 3>> bodies;
  double steps_shown;
  double printed_steps, printed_seconds;  // of the first body, mss-cf on 8 threads
};

/// Golec 2018, sections 5.7 to 5.9; bodies of table 5.5.
const std::vector<TimedScene>& timed_scenes() {
  static const std::vector<TimedScene> all{
      {.name = "compression",
       .figures = "5.20, 5.22-5.25",
       .load = SteppedLoad::plates,
       .poisson_ratio = 0.4,
       .bodies = {{10, 10, 10}, {15, 15, 15}, {20, 20, 20}, {30, 30, 30}},
       .steps_shown = 1000,
       .printed_steps = 10'000,
       .printed_seconds = 5.579},
      {.name = "beam under gravity",
       .figures = "5.21, 5.22",
       .load = SteppedLoad::weight,
       .poisson_ratio = 0.4,
       .bodies = {{4, 4, 24}, {8, 8, 48}, {10, 10, 60}, {16, 16, 96}},
       .steps_shown = 300'000,
       .printed_steps = 300'000,
       .printed_seconds = 74.149}};
  return all;
}

std::vector<int> thread_counts() {
  const auto most = static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  std::vector<int> counts;
  for (int threads = 1; threads < most; threads *= 2) counts.push_back(threads);
  counts.push_back(most);
  return counts;
}

/// A method whose steps are timed, and what its time is shown over.
struct Timed {
  const char* method;
  mss::Precision precision = mss::Precision::double_precision;
  Loops loops = Loops::kernel;
  bool over_naive = false;
  bool over_kernel = false;  // of the thesis's method, on as many threads
  bool is_thesis = false;    // whose times are printed
};

/// Plain loops first, the thesis's method before what is shown over it.
const std::vector<Timed>& timed_methods() {
  constexpr auto single = mss::Precision::single_precision;
  static const std::vector<Timed> all{
      {.method = "mss-cf", .loops = Loops::naive, .over_naive = true},
      {.method = "mss-nfd"},
      {.method = "mss-fd"},
      {.method = "mss-cf", .over_naive = true, .is_thesis = true},
      {.method = "mss-cf", .precision = single, .over_naive = true},
      {.method = "mss-affine", .over_kernel = true},
      {.method = "mss-tissue", .over_kernel = true},
      {.method = "fem-explicit-1p"},
      {.method = "fem-explicit-1p", .precision = single},
      {.method = "fem-explicit-8p"}};
  return all;
}

Table measured_table() {
  Table table{
      .columns = {{"scene", "scene"},
                  {"figures", "figures"},
                  {"cells", "cells", "{:.0f}"},
                  {"method", "method"},
                  {"precision", "precision"},
                  {"threads", "threads", "{:.0f}"},
                  {"ns_per_cell_step", "ns per cell and step", "{:.1f}"},
                  {"over_naive", "plain loops' time over it", "{:.1f}"},
                  {"over_cf", "over mss-cf's time", "{:.2f}"},
                  {"user_over_real", "user/real", "{:.2f}"},
                  {"steps", "steps of the figure", "{:.0f}"},
                  {"seconds", "time of so many [s]", "{:.4g}"},
                  {"printed_seconds", "printed, mss-cf on 8 threads [s]", "{:.4g}"},
                  {"seconds_as_printed", "ours for as many steps [s]", "{:.4g}"}},
      .notes = {
          fmt::format("Measured on {} (commit {}); the shortest of five measurements of "
                      ".04 s each, "
                      "and what follows from it for the figure's number of steps.",
                      text_of(environment()), build_info::commit),
          "fem-explicit-1p and -8p are St-Venant-Kirchhoff elements of one point with "
          "hourglass control and of eight points, by kernels of the same making.",
          "Plain loops: unique springs, square roots and divisions, one thread, mss-cf's "
          "network. Nu = 0.4, where mss-cf has corrections to compute; mss-nfd has them "
          "too, mss-fd has none.",
          "mss-tissue: spleen, with as many branches as are fitted by default; over the "
          "time of mss-cf on as many threads, like mss-affine.",
          "The thesis's times are of an Intel i7-4790K with 8 threads; its figures 5.23 "
          "to 5.25 of another machine with up to 36."}};
  for (const TimedScene& scene : timed_scenes())
    for (const auto& cells : scene.bodies) {
      const double count = double{1} * cells[0] * cells[1] * cells[2];
      std::optional<double> naive;
      std::map<int, double> thesis;  // its method's, by threads
      for (const Timed& timed : timed_methods())
        for (const int threads : thread_counts()) {
          const bool is_naive = timed.loops == Loops::naive;
          if (is_naive && threads > 1) continue;
          const StepTime time =
              time_of_steps(stepping({.method = timed.method,
                                      .cells = cells,
                                      .load = scene.load,
                                      .poisson_ratio = scene.poisson_ratio,
                                      .damping_ratio = 0,
                                      .precision = timed.precision,
                                      .instruction_set = dynamics::best_instruction_set(),
                                      .threads = threads,
                                      .loops = timed.loops})
                                .advance);
          if (is_naive) naive = time.real;
          if (timed.is_thesis) thesis[threads] = time.real;
          const bool is_printed = timed.is_thesis && cells == scene.bodies.front();
          const auto if_printed = [&](double value) {
            return Cell{is_printed ? std::optional(value) : std::nullopt};
          };
          table.rows.push_back(
              {.cells = {scene.name, scene.figures, count,
                         is_naive ? "plain loops" : timed.method,
                         name_of(timed.precision), threads, 1e9 * time.real / count,
                         timed.over_naive ? std::optional(naive.value() / time.real)
                                          : std::nullopt,
                         timed.over_kernel ? std::optional(time.real / thesis.at(threads))
                                           : std::nullopt,
                         time.user_over_real, scene.steps_shown,
                         scene.steps_shown * time.real, if_printed(scene.printed_seconds),
                         if_printed(scene.printed_steps * time.real)}});
        }
    }
  return table;
}

}  // namespace

TablePlan plan_performance_table() {
  return without_cases(measured_table);
}

}  // namespace springcheck
