#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "comparisons/command_line/command.hpp"

namespace springcheck {

/// What there is to say of an option, for help, completion and manual pages.
struct OptionText {
  std::vector<std::string> names;  // "-h", "--help"; of a positional one "SCENE"
  std::string type;                // see options.hpp; empty of a flag
  std::vector<std::string> words;  // that complete a value; none where it is any text
  std::string description;         // with its default
  std::string group;               // the heading of help
  bool is_positional;
  bool is_required;
  bool may_be_repeated;
};

struct CommandText {
  std::string name, summary, description;
  std::vector<Example> examples;
  std::vector<OptionText> options;  // positional ones first
  std::string footer;               // what holds of several options
};

/// The names of the list that capitals in an option's type stand for: of METHOD those of
/// methods; none where they stand for any text.
using NamesBehind = std::function<std::vector<std::string>(const std::string& capitals)>;

CommandText text_of(const Command& command, const NamesBehind& names_behind);

/// The text as JSON, and from what that made.
nlohmann::json json_of(const CommandText& command);
CommandText command_text_from(const nlohmann::json& json);

/// "springcheck sweep SWEEP --out FILE [OPTIONS]".
std::string usage_of(const CommandText& command);

/// The groups of options that are not positional: their headings in the order of the
/// first option of each, those without a group of their own last, of whom there are some
/// in every command.
std::vector<std::string> groups_of(const CommandText& command);

/// Whether files, or folders alone, complete it.
bool takes_files(const std::string& type);
bool takes_folders(const std::string& type);

}  // namespace springcheck
