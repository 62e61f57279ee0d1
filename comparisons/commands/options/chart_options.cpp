#include "comparisons/commands/options/chart_options.hpp"

#include <CLI/CLI.hpp>

#include "comparisons/command_line/options.hpp"
#include "comparisons/methods/methods.hpp"

namespace springcheck {
namespace {

std::vector<std::string_view> law_names() {
  std::vector<std::string_view> names;
  for (const Method* law : laws()) names.push_back(law->name);
  return names;
}

}  // namespace

CLI::Option* add_converged_across(CLI::App& parser, std::optional<int>& across) {
  return add_count(
      parser, "--converged-across", across, 1, 1000,
      "cells across of the coarsest of the three grids of q2 that tell the converged "
      "solution (default 4; 2 for bodies much longer than wide)");
}

CLI::Option* add_converged_law(CLI::App& parser, std::string& law) {
  return parser
      .add_option("--converged-law", law,
                  "method of the law whose converged solution errors are told from: " +
                      names_of(laws()) + " (default: that of the scene's reference)")
      ->type_name(alternatives(law_names()));
}

}  // namespace springcheck
