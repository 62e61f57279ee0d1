#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>

#include "comparisons/running/case_result.hpp"

namespace springcheck {

// Options of what several commands read.

CLI::Option* add_scene(CLI::App& parser, std::string& scene);

/// A result file.
CLI::Option* add_results(CLI::App& parser, std::filesystem::path& results);

/// `taken`: what of other revisions is taken.
CLI::Option* add_revisions(CLI::App& parser, Revisions& revisions,
                           const std::string& taken);

}  // namespace springcheck
