#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "comparisons/commands/commands.hpp"

namespace springcheck {

/// Whether stored values that are left behind are replaced in the gate file.
enum class Bless { no, yes };

/// `springcheck gate`: judges the results of a file by a gate file, or a shipped one of
/// that name, and prints the verdicts. done when all pass, fell_short when one does not,
/// bad_input when one has no case.
ExitStatus gate_command(const std::string& name_or_path,
                        const std::filesystem::path& results,
                        const std::optional<std::filesystem::path>& junit, Output output,
                        Bless bless, Revisions revisions);

}  // namespace springcheck
