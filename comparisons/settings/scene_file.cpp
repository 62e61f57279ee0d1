#include "comparisons/settings/scene_file.hpp"

#include <utility>

#include "comparisons/names/suggestion.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/settings/toml_values.hpp"
#include "comparisons/shipped/shipped.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

SceneFile scene_of(const TomlFile& scene) {
  const toml::table table = parse_toml(scene.text, scene.file);
  if (table.empty())
    throw InputError(scene.file + ":1:1", "", "settings", "an empty scene");
  GivenSettings settings;
  for (const auto& [key, node] : table) {
    if (find_setting(key.str()) == nullptr)
      refuse_name(place(scene.file, key.source()), "key", key.str(), setting_keys());
    settings.push_back({std::string(key.str()), given(node, scene.file, key.str())});
  }
  return {.name = scene.name, .file = scene.file, .settings = std::move(settings)};
}

}  // namespace

SceneFile read_scene(const std::string& name_or_path) {
  return scene_of(toml_file(name_or_path, a_scene));
}

SceneFile read_scene_named(const Given& name_or_path) {
  return scene_of(toml_file(name_or_path, a_scene));
}

RunSettings read_run(const SceneFile& scene, const GivenSettings& more) {
  return make_run_settings(scene.name, scene.file, scene.settings + more);
}

RunSettings read_run(const std::string& scene, const GivenSettings& more) {
  return read_run(read_scene(scene), more);
}

CaseSettings case_of_scene(const SceneFile& scene, const GivenSettings& more) {
  return requests(read_run(scene, more)).front().settings;
}

CaseSettings case_of_scene(const std::string& scene, const GivenSettings& more) {
  return case_of_scene(read_scene(scene), more);
}

}  // namespace springcheck
