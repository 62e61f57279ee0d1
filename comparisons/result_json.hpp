#pragma once

#include <nlohmann/json.hpp>

#include "comparisons/study.hpp"

namespace springcheck {

/// The JSON document of `run` (its fields are fixed, see the README's reference part): a
/// value that was not computed is null.
nlohmann::ordered_json run_json(const std::string& scene,
                                const std::vector<CaseResult>& results,
                                MeshStore& meshes);

}  // namespace springcheck
