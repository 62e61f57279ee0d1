#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "comparisons/studies/split.hpp"

namespace springcheck {

/// How a measure of a split is shown to people: name, unit, and the factor into it.
struct ShownMeasure {
  std::string name, unit;
  double factor;
};
ShownMeasure shown_measure(const std::string& measure);

/// The `split` object of `run --json` (its fields are described in the README).
nlohmann::ordered_json split_json(const Split& split);

/// The split in readable lines.
std::string split_text(const Split& split);

}  // namespace springcheck
