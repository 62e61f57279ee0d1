#include "comparisons/tables/studies/growth_table.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <map>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/running/progress.hpp"
#include "comparisons/running/stepping.hpp"
#include "comparisons/running/timing.hpp"
#include "comparisons/studies/extrapolation.hpp"
#include "comparisons/system/environment.hpp"
#include "comparisons/system/memory.hpp"
#include "comparisons/tables/plans/planned_requests.hpp"
#include "meshing/basics/stopwatch.hpp"

namespace springcheck {
namespace {

struct Cost {
  double seconds, bytes;
};

/// A way to compute whose cost grows.
struct Growing {
  std::string model, what;
  std::vector<int> across;
  std::function<std::optional<Cost>(int across)> cost;  // none of a failed solution
  std::function<double(int across)> expected_bytes;
};

GivenSettings cells_of(int n) {
  return {{"cells", std::array{n, n, n}}};
}

std::optional<Cost> cost_of_step(const char* method, Loops loops, int n) {
  const Stepping steps = stepping({.method = method,
                                   .cells = {n, n, n},
                                   .load = SteppedLoad::plates,
                                   .poisson_ratio = 0.4,
                                   .damping_ratio = 0,
                                   .precision = mss::Precision::double_precision,
                                   .instruction_set = dynamics::best_instruction_set(),
                                   .threads = 1,
                                   .loops = loops});
  return Cost{.seconds = time_of_steps(steps.advance).real, .bytes = steps.bytes};
}

/// Time of the solution, and the peak of memory that it adds to the mesh.
std::optional<Cost> cost_of(const CaseSettings& settings) {
  const Mesh mesh = build_mesh(settings.body);
  const Scene scene = mechanical_scene(settings, mesh);
  malloc_trim(0);
  const double before = resident_memory();
  reset_peak_memory();
  const Stopwatch stopwatch;
  tbb::task_arena arena(1);
  const Solution solution =
      arena.execute([&] { return settings.method.solve(settings, mesh, scene, 1, {}); });
  if (solution.status != SolveStatus::ok) return std::nullopt;
  return Cost{.seconds = stopwatch.seconds(), .bytes = peak_memory() - before};
}

std::vector<Growing> all_growing(const std::vector<int>& wide,
                                 const std::vector<int>& narrow) {
  std::vector<Growing> all;
  const auto add_steps = [&](const char* model, const char* method, Loops loops) {
    all.push_back(
        {.model = model,
         .what = "explicit step",
         .across = wide,
         .cost = [=](int n) { return cost_of_step(method, loops, n); },
         .expected_bytes = [](int n) { return 4e3 * std::pow(n, 3); }});  // measured 3e3
  };
  add_steps("plain loops", "mss-cf", Loops::naive);
  for (const char* method :
       {"mss-nfd", "mss-cf", "mss-affine", "fem-explicit-1p", "fem-explicit-8p"})
    add_steps(method, method, Loops::kernel);
  for (const char* method : {"mss-cf", "fem-stvk"})
    for (const char* linear_solver : {"direct", "conjugate-gradients", "multigrid"}) {
      const auto settings = [=](int n) {
        return case_of_scene(
            "compression",
            GivenSettings{{"method", method}, {"linear-solver", linear_solver}} +
                cells_of(n));
      };
      all.push_back(
          {.model = label(settings(narrow.front())),
           .what = fmt::format("equilibrium, {}", linear_solver),
           .across = linear_solver == std::string_view("direct") ? narrow : wide,
           .cost = [=](int n) { return cost_of(settings(n)); },
           .expected_bytes = [=](int n) { return estimated_memory(settings(n)); }});
    }
  return all;
}

void add_rows(Table& table, const Growing& growing, double most_seconds) {
  std::vector<double> cells, seconds, bytes;
  std::map<double, double> seconds_by_cells;
  for (const int n : growing.across) {
    const double count = std::pow(n, 3);
    const double expected = expected_seconds(seconds_by_cells, count);
    std::string reason;
    if (growing.expected_bytes(n) > available_memory())
      reason = "not run: more memory than is left";
    else if (expected > most_seconds)
      reason = fmt::format("not run: may take {:.0f} s", expected);
    const std::optional<Cost> cost = reason.empty() ? growing.cost(n) : std::nullopt;
    if (reason.empty() && !cost) reason = "failed";
    if (!reason.empty()) {
      table.notes.push_back(fmt::format("{}, {}, {:.0f} cells: {}.", growing.model,
                                        growing.what, count, reason));
      continue;
    }
    cells.push_back(count);
    seconds.push_back(cost->seconds);
    bytes.push_back(cost->bytes);
    seconds_by_cells[count] = cost->seconds;
  }
  std::optional<double> time_exponent, memory_exponent;
  if (cells.size() > 1) {
    time_exponent = fitted_order(cells, seconds);
    memory_exponent = fitted_order(cells, bytes);
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
    table.rows.push_back(
        {.cells = {growing.model, growing.what, cells[i], seconds[i],
                   1e9 * seconds[i] / cells[i], time_exponent,
                   bytes[i] > 0 ? std::optional(bytes[i] / 1e6) : std::nullopt,
                   memory_exponent}});
}

}  // namespace

Table growth_table(const std::vector<int>& across,
                   const std::vector<int>& across_directly, double most_seconds) {
  Table table{
      .columns = {{"model", "model"},
                  {"what", "what"},
                  {"cells", "cells", "{:.0f}"},
                  {"seconds", "time [s]", "{:.4g}"},
                  {"ns_per_cell", "ns per cell", "{:.4g}"},
                  {"time_exponent", "exponent", "{:.3f}"},
                  {"megabytes", "memory [MB]", "{:.4g}"},
                  {"memory_exponent", "exponent", "{:.3f}"}},
      .notes = {
          fmt::format("Measured on {} (commit {}), one thread.", text_of(environment()),
                      build_info::commit),
          "Exponents: least squares of the logarithms over all sizes of the series. "
          "Explicit steps at nu = .4, the shortest of five measurements of .1 s or one "
          "step each; memory: the arrays and constants that move, without mesh. "
          "Equilibria: compression by 5 % at nu = .25, set-up and all, once; memory: "
          "peak beyond the mesh."}};
  const std::vector<Growing> all = all_growing(across, across_directly);
  Progress progress("series");
  for (std::size_t i = 0; i < all.size(); ++i) {
    progress.show(i, all.size());
    add_rows(table, all[i], most_seconds);
  }
  return table;
}

TablePlan plan_growth_table() {
  return {.make = [](std::span<const CaseResult>, MeshStore&) {
    return growth_table({10, 22, 46, 100}, {10, 14, 20, 28});
  }};
}

}  // namespace springcheck
