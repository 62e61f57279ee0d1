#pragma once

#include "comparisons/settings/scene_file.hpp"

namespace springcheck {

/// Changes as options of the command line.
inline std::vector<GivenSetting> options_of(const Changes& changes) {
  std::vector<GivenSetting> options;
  for (const auto& [key, value] : changes) options.push_back({key, value});
  return options;
}

}  // namespace springcheck
