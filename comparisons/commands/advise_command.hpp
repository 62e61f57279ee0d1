#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/commands/commands.hpp"

namespace springcheck {

struct AdviseOptions {
  std::string tolerance;                // "0.08" or "8%"
  std::vector<std::string> measures{};  // force, volume, deviation; empty: all there are
  std::string law{};                    // of the truth; empty: the scene's
  std::string real_time{};              // [s] of a frame; empty: an equilibrium is wanted
  double budget = 20;                   // [s] that a solution may take
  std::filesystem::path out{};          // result file; empty: none is kept
  std::filesystem::path scene_file{};   // empty: NAME-advised.toml
  std::optional<int> truth_across{};    // see truth_grids
  int jobs = 1;                         // truths at once, at most
};

/// `springcheck advise`: the cheapest model of a scene that meets a tolerance, with its
/// neighbours and a scene file that runs it. ExitStatus::fell_short, and what comes
/// closest, where none does.
ExitStatus advise_command(const std::string& scene,
                          const std::vector<GivenSetting>& options,
                          const AdviseOptions& advise);

}  // namespace springcheck
