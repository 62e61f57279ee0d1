#pragma once

#include <string>
#include <vector>

#include "comparisons/settings/run_settings.hpp"
#include "comparisons/settings/scene_file.hpp"

namespace springcheck {

/// A run of a shipped scene with settings changed, each "key=value".
inline RunSettings run_of(const std::string& scene,
                          const std::vector<std::string>& changes) {
  GivenSettings given;
  for (const std::string& change : changes) {
    const std::size_t equals = change.find('=');
    const std::string key = change.substr(0, equals);
    given.push_back({key, Given::from_text("--" + key, change.substr(equals + 1))});
  }
  return read_run(scene, given);
}

/// Settings of its only method.
inline CaseSettings case_of(const std::string& scene,
                            const std::vector<std::string>& changes) {
  return requests(run_of(scene, changes)).front().settings;
}

}  // namespace springcheck
