#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "comparisons/studies/split.hpp"

namespace springcheck {

/// The `split` object of `run --json`; docs/how-to/split-errors.md tells its fields.
nlohmann::ordered_json split_json(const Split& split);

/// The split in readable lines.
std::string split_text(const Split& split);

}  // namespace springcheck
