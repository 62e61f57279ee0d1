#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "comparisons/studies/study.hpp"

namespace springcheck {

inline const std::vector<std::string> small{"cells=4,4,4", "method=mss-cf,fem-hooke"};

inline std::vector<CaseResult> study(const std::vector<Request>& requests,
                                     MeshStore& meshes) {
  return run_study(requests, meshes, 1, [](std::size_t, std::size_t) {});
}

}  // namespace springcheck
