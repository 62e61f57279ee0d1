#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/commands/commands.hpp"

namespace springcheck {

struct StabilityOptions {
  std::vector<std::string> over{};  // see axes_named
  std::optional<std::filesystem::path> out{};
  std::optional<TableFormat> format{};  // none: maps and limits for a terminal
  bool locking = false;                 // see AtlasPlan
  int jobs = 1;                         // simulations at once, at most
  Revisions revisions = Revisions::own;
};

/// `springcheck stability`: maps where methods fail over one or two settings, and their
/// limits along the first. What the result file holds is not computed again.
ExitStatus stability_command(const std::string& scene,
                             const std::vector<GivenSetting>& options,
                             const StabilityOptions& stability);

}  // namespace springcheck
