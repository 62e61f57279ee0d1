#include "comparisons/settings/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "comparisons/settings/toml_values.hpp"
#include "comparisons/shipped/shipped.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

std::string known_keys() {
  return names_of(scene_only_keys()) + ", " + names_of(option_keys());
}

bool is_known(std::string_view key) {
  const auto is_key = [&](const SettingKey& known) { return known.name == key; };
  return std::ranges::any_of(option_keys(), is_key) ||
         std::ranges::any_of(scene_only_keys(), is_key);
}

SceneFile scene_of(const TomlFile& scene) {
  const toml::table table = parse_toml(scene.text, scene.file);
  if (table.empty())
    throw InputError(scene.file + ":1:1", "", "settings", "an empty scene");
  std::vector<GivenSetting> settings;
  for (const auto& [key, node] : table) {
    if (!is_known(key.str()))
      throw InputError(place(scene.file, key.source()), "", "one of " + known_keys(),
                       fmt::format("unknown key '{}'", key.str()));
    settings.push_back({std::string(key.str()), given(node, scene.file, key.str())});
  }
  return {.name = scene.name, .file = scene.file, .settings = std::move(settings)};
}

}  // namespace

SceneFile read_scene(const std::string& name_or_path) {
  return scene_of(toml_file(name_or_path, "scene", shipped_scenes()));
}

SceneFile read_scene(const Given& name_or_path) {
  return scene_of(toml_file(name_or_path, "scene", shipped_scenes()));
}

RunSettings read_run(const std::string& scene, const std::vector<GivenSetting>& options) {
  SceneFile file = read_scene(scene);
  file.settings.insert(file.settings.end(), options.begin(), options.end());
  return make_run_settings(file.name, file.file, file.settings);
}

CaseSettings case_of_scene(const std::string& scene, const Changes& changes) {
  SceneFile file = read_scene(scene);
  for (const auto& [key, value] : changes)
    file.settings.push_back({key, Given::from_text("table", value)});
  return requests(make_run_settings(file.name, file.file, file.settings))
      .front()
      .settings;
}

}  // namespace springcheck
