#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "comparisons/settings/given.hpp"
#include "comparisons/shipped/shipped.hpp"

namespace springcheck {

/// A TOML file as its user names it.
struct TomlFile {
  std::string name;  // without folder and extension
  std::string file;  // as messages name it
  std::string text;
};

/// What a TOML file may be.
struct TomlKind {
  std::string_view name;  // "scene"
  std::string_view key;   // which its files have, and no others
  std::string_view command;
  const std::vector<ShippedFile>& (*shipped)();
};
inline constexpr TomlKind a_scene{"scene", "test", "run", shipped_scenes};
inline constexpr TomlKind a_sweep{"sweep", "scene", "sweep", shipped_sweeps};
inline constexpr TomlKind a_gate_file{"gate", "gate", "gate", shipped_gates};

/// The shipped file of that name, or the one at that path (a name that ends in .toml or
/// holds a slash). Throws InputError when there is none, it cannot be read, or it is of
/// another kind.
TomlFile toml_file(const std::string& name_or_path, const TomlKind& kind);

/// The same of a file that another names: a relative path stands beside that one, and
/// messages say where it is named.
TomlFile toml_file(const Given& name_or_path, const TomlKind& kind);

/// Whether toml_file takes the name for a path.
bool is_toml_path(const std::string& name_or_path);

/// Throws InputError with file, line and column where the text is no TOML.
toml::table parse_toml(std::string_view text, const std::string& file);

/// "scene.toml:4:7"
std::string place(const std::string& file, const toml::source_region& source);

/// A number, text, truth value, or a table of them and of lists, which may be lists of
/// lists; others are kept unreadable, for the message of who reads them.
Given::Scalar scalar(const toml::node& node, const std::string& file);

/// A scalar or a list of them, whose place is "scene.toml:4:7: key".
Given given(const toml::node& node, const std::string& file, std::string_view key);

}  // namespace springcheck
