#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparisons/studies/split.hpp"

namespace springcheck {

/// The JSON document of `run` (its fields are fixed, see the README's reference part): a
/// value that was not computed is null. `splits` holds one entry per result.
nlohmann::ordered_json run_json(const std::string& scene,
                                const std::vector<CaseResult>& results,
                                const std::vector<std::optional<Split>>& splits,
                                MeshStore& meshes);

/// The JSON schema of run_json().
nlohmann::ordered_json run_schema();

}  // namespace springcheck
