#pragma once

#include <cmath>
#include <map>
#include <string>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/chart/chart.hpp"

namespace springcheck {

inline StoredCase case_of(double force, double volume_change) {
  StoredCase stored{.status = Status::ok,
                    .flags = {},
                    .reason = {},
                    .measures = {},
                    .effort = Effort{},
                    .linear_iterations = {},
                    .factorisations = {},
                    .dt = {},
                    .dt_limit = {}};
  stored.measures.plate_force = force;
  stored.measures.volume_change = volume_change;
  return stored;
}

inline Timing around(double seconds) {
  return timing_of(
      {{0.8 * seconds, 0.9 * seconds, seconds, 1.1 * seconds, 1.2 * seconds}});
}

/// A truth of second order: force 10 + 80/9 h^2, volume change -.02 + .05/9 h^2, on cells
/// of 1, 1/2 and 1/4, so that error bounds are 2.25 times 5/9 and 1/2880; imposed .1 m on
/// 2 m.
struct ExampleChart {
  StoredChart chart{.scene = "compression",
                    .settings = "of its models",
                    .law = "fem-stvk",
                    .answer = "plate_force",
                    .height = 2,
                    .imposed = 0.1,
                    .machine = "a machine",
                    .truths = {{.law = "fem-stvk",
                                .grids = {.cell_sizes = {1, 0.5, 0.25},
                                          .keys = {"t1", "t2", "t3"},
                                          .formal_order = 2}}},
                    .points = {},
                    .comparisons = {},
                    .revision = build_info::revision};
  std::map<std::string, StoredCase> cases{
      {"t1", case_of(10 + 80. / 9, -0.02 + 0.05 / 9)},
      {"t2", case_of(10 + 20. / 9, -0.02 + 0.0125 / 9)},
      {"t3", case_of(10 + 5. / 9, -0.02 + 0.003125 / 9)}};

  /// Checks the truth: force 10 + 80/9 (h - 1/8), volume change as the truth's, on cells
  /// of 1/2, 1/4 and 1/8, by a formal order of 1.
  void check_truth() {
    chart.truths[0].check = StoredChart::Grids{
        .cell_sizes = {0.5, 0.25, 0.125}, .keys = {"c1", "c2", "c3"}, .formal_order = 1};
    for (const int i : {1, 2, 3})
      cases.insert_or_assign("c" + std::to_string(i),
                             case_of(10 + 80. / 9 * (std::pow(2, -i) - 0.125), -0.02));
  }

  StoredCase& add(const std::string& model, int across, double seconds, double force,
                  double deviation, ChartKind kind = ChartKind::equilibrium) {
    const std::string key = model + std::to_string(across);
    chart.points.push_back(
        {.model = model_in(model),
         .kind = kind,
         .across = across,
         .cells = std::pow(across, 3),
         .nodes = std::pow(across + 1, 3),
         .threads = 1,
         .key = key,
         .left_out = std::nullopt,
         .timing = around(seconds),
         .setup = 0.1 * seconds,
         .simulated = kind == ChartKind::motion ? std::optional(10.) : std::nullopt});
    chart.comparisons.push_back(
        {.key = key, .law = "fem-stvk", .compared = key + " compared"});
    StoredCase compared = case_of(force, -0.02);
    compared.measures.deviation_l2_relative = deviation;
    compared.measures.reference_bar_l2_relative = 1e-3;
    cases.emplace(key + " compared", compared);
    return cases.emplace(key, case_of(force, -0.021)).first->second;
  }
};

}  // namespace springcheck
