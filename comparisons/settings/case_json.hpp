#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparisons/cases/case.hpp"

namespace springcheck {

/// The scene's name and the settings its test, method and solver read, and no others, as
/// JSON: a setting that cannot change the result does not change it. What was measured
/// has instead "source": "measured" and the SHA-256 of its numbers, "displacements" and
/// "forces".
nlohmann::json settings_json(const CaseSettings& settings);

}  // namespace springcheck
