#pragma once

#include <string_view>
#include <vector>

namespace springcheck {

/// A text file compiled into the program; CMakeLists.txt lists them.
struct ShippedFile {
  std::string_view name;  // "compression.toml"
  std::string_view text;
};

/// scenes/*.toml
const std::vector<ShippedFile>& shipped_scenes();

/// sweeps/*.toml
const std::vector<ShippedFile>& shipped_sweeps();

/// gates/*.toml
const std::vector<ShippedFile>& shipped_gates();

/// reports/springcheck_results.py and reports/springcheck_report/*, with these paths
const std::vector<ShippedFile>& shipped_report();

/// printed.csv
std::string_view shipped_figures();

}  // namespace springcheck
