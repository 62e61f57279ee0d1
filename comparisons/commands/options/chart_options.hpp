#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

namespace springcheck {

// Options of `chart` and `advise`, which measure beside the same converged solutions.
CLI::Option* add_converged_across(CLI::App& parser, std::optional<int>& across);
CLI::Option* add_converged_law(CLI::App& parser, std::string& law);

}  // namespace springcheck
