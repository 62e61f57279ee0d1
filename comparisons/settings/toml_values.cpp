#include "comparisons/settings/toml_values.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "comparisons/settings/suggestion.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

std::string text_of_file(const std::string& file, const std::string& kind) {
  if (std::filesystem::is_directory(file))
    throw InputError(file + ":1:1", "", "a " + kind + " file", "a directory");
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError(file + ":1:1", "", "a readable " + kind + " file",
                     std::strerror(errno));
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
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

std::optional<TomlFile> shipped_file(const std::string& name,
                                     const std::vector<ShippedFile>& shipped) {
  for (const ShippedFile& one : shipped)
    if (std::filesystem::path(one.name).stem() == name)
      return TomlFile{
          .name = name, .file = std::string(one.name), .text = std::string(one.text)};
  return std::nullopt;
}

/// Names, of which the likely one is told, or a path.
[[noreturn]] void refuse_toml(const std::string& place, const std::string& kind,
                              const std::string& name,
                              const std::vector<ShippedFile>& shipped) {
  std::vector<std::string> names;
  for (const ShippedFile& one : shipped)
    names.push_back(std::filesystem::path(one.name).stem().string());
  std::vector<std::string_view> known(names.begin(), names.end());
  known.push_back("a path to a .toml file");
  refuse_name(place, kind, name, known);
}

}  // namespace

bool is_toml_path(const std::string& name_or_path) {
  const std::filesystem::path path(name_or_path);
  return path.extension() == ".toml" || path.has_parent_path();
}

TomlFile toml_file(const std::string& name_or_path, const std::string& kind,
                   const std::vector<ShippedFile>& shipped) {
  if (is_toml_path(name_or_path))
    return {.name = std::filesystem::path(name_or_path).stem().string(),
            .file = name_or_path,
            .text = text_of_file(name_or_path, kind)};
  if (auto file = shipped_file(name_or_path, shipped)) return *std::move(file);
  refuse_toml("springcheck", kind, name_or_path, shipped);
}

TomlFile toml_file(const Given& name_or_path, const std::string& kind,
                   const std::vector<ShippedFile>& shipped) {
  const std::string name = name_or_path.text();
  if (is_toml_path(name)) {
    if (!std::ifstream(name_or_path.path()))
      throw InputError(name_or_path.place(), "", "a readable " + kind + " file",
                       "'" + name_or_path.path() + "': " + std::strerror(errno));
    return toml_file(name_or_path.path(), kind, shipped);
  }
  if (auto file = shipped_file(name, shipped)) return *std::move(file);
  refuse_toml(name_or_path.place(), kind, name, shipped);
}

toml::table parse_toml(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw InputError(place(file, error.source()), "", "TOML",
                     std::string(error.description()));
  }
}

std::string place(const std::string& file, const toml::source_region& source) {
  return fmt::format("{}:{}:{}", file, source.begin.line, source.begin.column);
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

}  // namespace springcheck
