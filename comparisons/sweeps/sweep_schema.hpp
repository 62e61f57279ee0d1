#pragma once

#include <nlohmann/json_fwd.hpp>

namespace springcheck {

/// JSON schema of sweep files: options of `run`, each with a value or those that it takes
/// in turn.
nlohmann::ordered_json sweep_schema();

}  // namespace springcheck
