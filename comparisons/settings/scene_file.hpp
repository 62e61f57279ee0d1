#pragma once

#include <string>

#include "comparisons/settings/run_settings.hpp"

namespace springcheck {

/// A scene as its file states it.
struct SceneFile {
  std::string name;  // without folder and extension
  std::string file;  // as messages name it
  GivenSettings settings;
};

/// Reads the shipped scene of that name, or the file at that path (a name that ends in
/// .toml or holds a slash). Unknown keys, wrong types, unreadable and empty files throw
/// InputError with file, line and column.
SceneFile read_scene(const std::string& name_or_path);

/// The same of a scene that a file names: a relative path stands beside that file, and
/// messages say where it is named.
SceneFile read_scene_named(const Given& name_or_path);

/// The run of a scene with more settings, which replace its own. Throws InputError.
RunSettings read_run(const SceneFile& scene, const GivenSettings& more);
RunSettings read_run(const std::string& scene, const GivenSettings& more);

/// The first simulation of that run, without its reference.
CaseSettings case_of_scene(const SceneFile& scene, const GivenSettings& more);
CaseSettings case_of_scene(const std::string& scene, const GivenSettings& more);

}  // namespace springcheck
