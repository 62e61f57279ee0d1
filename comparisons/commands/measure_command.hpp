#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/commands/commands.hpp"

namespace springcheck {

/// What another program computed, as the user names it.
struct MeasuredFiles {
  std::filesystem::path displacements;          // .vtu or .csv
  std::optional<std::filesystem::path> forces;  // .csv
  std::string label;                            // stands for the method
};

/// `springcheck measure`: prints the measures of another program's result as a case of
/// the scene, writes it to `result_file` when given; warns of what contradicts the scene.
ExitStatus measure_command(const std::string& scene,
                           const std::vector<GivenSetting>& options,
                           const MeasuredFiles& files,
                           const std::optional<std::filesystem::path>& result_file,
                           Output output);

}  // namespace springcheck
