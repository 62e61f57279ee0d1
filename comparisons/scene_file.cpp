#include "comparisons/scene_file.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

#include "comparisons/shipped.hpp"
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

std::string place(const std::string& file, const toml::source_region& source) {
  return fmt::format("{}:{}:{}", file, source.begin.line, source.begin.column);
}

/// What is no scalar, on one line.
std::string written(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (const auto number = node.value_exact<double>()) return fmt::to_string(*number);
  if (const toml::array* list = node.as_array()) {
    std::string items;
    for (const toml::node& item : *list)
      items += (items.empty() ? "" : ", ") + written(item);
    return "[" + items + "]";
  }
  std::ostringstream text;
  text << toml::toml_formatter(node);
  return text.str();
}

Given::Scalar scalar(const toml::node& node) {
  if (const auto value = node.value_exact<bool>()) return *value;
  if (const auto value = node.value_exact<std::int64_t>()) return *value;
  if (const auto value = node.value_exact<double>()) return *value;
  if (const auto value = node.value_exact<std::string>()) return *value;
  return Given::Unreadable{written(node)};
}

Given given(const toml::node& node, const std::string& file, std::string_view key) {
  const std::string where = fmt::format("{}: {}", place(file, node.source()), key);
  const toml::array* list = node.as_array();
  if (list == nullptr) return {where, scalar(node)};
  std::vector<Given::Scalar> values;
  for (const toml::node& element : *list) values.push_back(scalar(element));
  return {where, values};
}

bool is_utf8(const std::string& text) {
  try {
    std::ignore = nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

std::string text_of_file(const std::string& file) {
  if (std::filesystem::is_directory(file))
    throw InputError(file + ":1:1", "", "a scene file", "a directory");
  std::ifstream in(file);
  if (!in)
    throw InputError(file + ":1:1", "", "a readable scene file", std::strerror(errno));
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::vector<GivenSetting> parse(std::string_view text, const std::string& file) {
  toml::table table;
  try {
    table = toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw InputError(place(file, error.source()), "", "TOML",
                     std::string(error.description()));
  }
  if (table.empty()) throw InputError(file + ":1:1", "", "settings", "an empty scene");
  std::vector<GivenSetting> settings;
  for (const auto& [key, node] : table) {
    if (!is_known(key.str()))
      throw InputError(place(file, key.source()), "", "one of " + known_keys(),
                       fmt::format("unknown key '{}'", key.str()));
    settings.push_back({std::string(key.str()), given(node, file, key.str())});
  }
  return settings;
}

}  // namespace

SceneFile read_scene(const std::string& name_or_path) {
  if (!is_utf8(name_or_path))  // it goes into JSON and HDF5
    throw InputError("scene", "", "a name in UTF-8", "other bytes");
  const std::filesystem::path path(name_or_path);
  if (path.extension() == ".toml" || path.has_parent_path())
    return {.name = path.stem().string(),
            .file = name_or_path,
            .settings = parse(text_of_file(name_or_path), name_or_path)};

  std::string names;
  for (const ShippedFile& scene : shipped_scenes()) {
    const std::string name = std::filesystem::path(scene.name).stem().string();
    if (name == name_or_path) {
      const std::string file(scene.name);
      return {.name = name, .file = file, .settings = parse(scene.text, file)};
    }
    names += (names.empty() ? "" : ", ") + name;
  }
  throw InputError("scene", "", "one of " + names + ", or a path to a .toml file",
                   "'" + name_or_path + "'");
}

}  // namespace springcheck
