#pragma once

#include <string>
#include <utility>
#include <vector>

#include "comparisons/settings/run_settings.hpp"

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

/// The same of a scene that a file names: a relative path stands beside that file, and
/// messages say where it is named.
SceneFile read_scene(const Given& name_or_path);

/// The run of that scene with options, which replace its settings. Throws InputError.
RunSettings read_run(const std::string& scene, const std::vector<GivenSetting>& options);

/// Changes of a scene's settings, {key, value}.
using Changes = std::vector<std::pair<std::string, std::string>>;

/// Both lists, the second's values over the first's.
inline Changes operator+(Changes all, const Changes& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// The one simulation of a shipped scene with settings changed, {key, value}, without a
/// reference.
CaseSettings case_of_scene(const std::string& scene, const Changes& changes);

}  // namespace springcheck
