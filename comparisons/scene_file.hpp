#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "comparisons/run_settings.hpp"

namespace springcheck {

/// A scene as its file states it.
struct SceneFile {
  std::string name;  // without folder and extension
  std::string file;  // as messages name it
  std::vector<GivenSetting> settings;
};

/// Reads the shipped scene of that name, or the file at that path (a name that ends in
/// .toml or holds a slash). Unknown keys, wrong types, unreadable and empty files throw
/// InputError with file, line and column.
SceneFile read_scene(const std::string& name_or_path);

/// The run of that scene with options, which replace its settings. Throws InputError.
RunSettings read_run(const std::string& scene, const std::vector<GivenSetting>& options);

}  // namespace springcheck
