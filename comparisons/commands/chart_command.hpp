#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/commands/commands.hpp"

namespace springcheck {

struct ChartOptions {
  std::string sizes = "4,6,10,16";  // cells across
  std::string threads{};            // "1,2"; empty: 1 and all
  double budget = 8;                // [s] that a point's solution may take
  double repeat_for = 1;            // [s] of a point's repetitions, in all rounds
  std::string law{};  // of the scene's own truth; empty: that of its reference
  std::filesystem::path out{};
  std::optional<TableFormat> format{};  // none: truths, fronts and claims for a terminal
  int jobs = 1;                         // truths at once, at most
  bool retime = false;
  bool quick = false;                 // quick_plan's models, sizes and times
  int least_models = 12;              // see ChartRun::measure_beyond_budget
  std::optional<int> truth_across{};  // see truth_grids
};

/// `springcheck chart`: measures how long each model takes and how far it is off the
/// truth of a scene, or of the five scenes of the thesis ("all"). What the result file
/// holds is not measured again.
ExitStatus chart_command(const std::string& scene,
                         const std::vector<GivenSetting>& options,
                         const ChartOptions& chart);

}  // namespace springcheck
