#include "comparisons/settings/toml_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "comparisons/names/suggestion.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

constexpr TomlKind every_kind[] = {a_scene, a_sweep, a_gate_file};

[[noreturn]] void refuse_kind(const std::string& place, const TomlKind& kind,
                              const std::string& got, const TomlKind& got_kind) {
  throw InputError(place, "", fmt::format("a {} file", kind.name),
                   fmt::format("{}, which springcheck {} takes", got, got_kind.command));
}

/// Throws InputError where the text is of another kind; what is none stays.
void check_kind(const std::string& text, const std::string& file, const TomlKind& kind) {
  const toml::table table = parse_toml(text, file);
  if (table.contains(kind.key)) return;
  for (const TomlKind& other : every_kind)
    if (const toml::node* const node = table.get(other.key))
      refuse_kind(place(file, node->source()), kind, fmt::format("a {} file", other.name),
                  other);
}

std::string text_of_file(const std::string& file, const TomlKind& kind) {
  if (std::filesystem::is_directory(file))
    throw InputError(file + ":1:1", "", fmt::format("a {} file", kind.name),
                     "a directory");
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError(file + ":1:1", "", fmt::format("a readable {} file", kind.name),
                     std::strerror(errno));
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// What is no scalar, on one line.
std::string written(const toml::node& node) {
  if (const auto number = node.value_exact<double>()) return fmt::to_string(*number);
  if (const toml::array* list = node.as_array()) {
    std::vector<std::string> items;
    for (const toml::node& item : *list) items.push_back(written(item));
    return fmt::format("[{}]", fmt::join(items, ", "));
  }
  std::ostringstream text;
  text << toml::toml_formatter(node);
  return text.str();
}

std::optional<TomlFile> shipped_file(const std::string& name,
                                     const std::vector<ShippedFile>& shipped) {
  for (const ShippedFile& one : shipped)
    if (std::filesystem::path(one.name).stem() == name)
      return TomlFile{
          .name = name, .file = std::string(one.name), .text = std::string(one.text)};
  return std::nullopt;
}

/// Names, of which the likely one is told, or a path.
[[noreturn]] void refuse_toml(const std::string& place, const TomlKind& kind,
                              const std::string& name) {
  for (const TomlKind& other : every_kind)
    if (shipped_file(name, other.shipped()))
      refuse_kind(place, kind, fmt::format("'{}', a {}", name, other.name), other);
  if (kind.name == "scene" && name.ends_with(".msh"))
    throw InputError(place, "", fmt::format("a scene, and behind it --mesh {}", name),
                     fmt::format("the mesh '{}'", name));
  std::vector<std::string> names;
  for (const ShippedFile& one : kind.shipped())
    names.push_back(std::filesystem::path(one.name).stem().string());
  std::vector<std::string_view> known(names.begin(), names.end());
  known.push_back("a path to a .toml file");
  refuse_name(place, kind.name, name, known);
}

}  // namespace

bool is_toml_path(const std::string& name_or_path) {
  const std::filesystem::path path(name_or_path);
  return path.extension() == ".toml" || path.has_parent_path();
}

TomlFile toml_file(const std::string& name_or_path, const TomlKind& kind) {
  if (is_toml_path(name_or_path)) {
    TomlFile file{.name = std::filesystem::path(name_or_path).stem().string(),
                  .file = name_or_path,
                  .text = text_of_file(name_or_path, kind)};
    check_kind(file.text, file.file, kind);
    return file;
  }
  if (auto file = shipped_file(name_or_path, kind.shipped())) return *std::move(file);
  refuse_toml("springcheck", kind, name_or_path);
}

TomlFile toml_file(const Given& name_or_path, const TomlKind& kind) {
  const std::string name = name_or_path.text();
  if (is_toml_path(name)) {
    if (!std::ifstream(name_or_path.path()))
      throw InputError(name_or_path.place(), "",
                       fmt::format("a readable {} file", kind.name),
                       "'" + name_or_path.path() + "': " + std::strerror(errno));
    return toml_file(name_or_path.path(), kind);
  }
  if (auto file = shipped_file(name, kind.shipped())) return *std::move(file);
  refuse_toml(name_or_path.place(), kind, name);
}

toml::table parse_toml(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    std::string found(error.description());
    if (found.starts_with("Error while")) found = "an e" + found.substr(1);
    throw InputError(place(file, error.source()), "", "TOML", found);
  }
}

std::string place(const std::string& file, const toml::source_region& source) {
  return fmt::format("{}:{}:{}", file, source.begin.line, source.begin.column);
}

/// The values of a list and of the lists in it, in order.
static void append_flat(const toml::node& node, const std::string& file,
                        std::vector<Given::Scalar>& values) {
  if (const toml::array* list = node.as_array())
    for (const toml::node& element : *list) append_flat(element, file, values);
  else
    values.push_back(scalar(node, file));
}

static Given::Table table_of(const toml::table& table, const std::string& file) {
  GivenSettings entries;
  for (const auto& [key, node] : table) {
    const std::string where = fmt::format("{}: {}", place(file, key.source()), key.str());
    std::vector<Given::Scalar> values;
    append_flat(node, file, values);
    entries.push_back({std::string(key.str()), node.is_array()
                                                   ? Given(where, std::move(values))
                                                   : Given(where, values.front())});
  }
  return {.place = place(file, table.source()),
          .entries = std::make_shared<const GivenSettings>(std::move(entries))};
}

Given::Scalar scalar(const toml::node& node, const std::string& file) {
  if (const auto value = node.value_exact<bool>()) return *value;
  if (const auto value = node.value_exact<std::int64_t>()) return *value;
  if (const auto value = node.value_exact<double>()) return *value;
  if (const auto value = node.value_exact<std::string>()) return *value;
  if (const toml::table* table = node.as_table()) return table_of(*table, file);
  return Given::Unreadable{written(node)};
}

Given given(const toml::node& node, const std::string& file, std::string_view key) {
  const std::string where = fmt::format("{}: {}", place(file, node.source()), key);
  const toml::array* list = node.as_array();
  if (list == nullptr) return {where, scalar(node, file)};
  std::vector<Given::Scalar> values;
  for (const toml::node& element : *list) values.push_back(scalar(element, file));
  return {where, values};
}

}  // namespace springcheck
