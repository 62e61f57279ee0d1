#include "comparisons/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/shipped.hpp"
#include "comparisons/toml_values.hpp"
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

}  // namespace

SceneFile read_scene(const std::string& name_or_path) {
  const TomlFile toml = toml_file(name_or_path, "scene", shipped_scenes());
  const toml::table table = parse_toml(toml.text, toml.file);
  if (table.empty())
    throw InputError(toml.file + ":1:1", "", "settings", "an empty scene");
  SceneFile scene{.name = toml.name, .file = toml.file, .settings = {}};
  for (const auto& [key, node] : table) {
    if (!is_known(key.str()))
      throw InputError(place(toml.file, key.source()), "", "one of " + known_keys(),
                       fmt::format("unknown key '{}'", key.str()));
    scene.settings.push_back({std::string(key.str()), given(node, toml.file, key.str())});
  }
  return scene;
}

}  // namespace springcheck
