#pragma once

#include <string>
#include <vector>

#include "comparisons/command_line/command.hpp"

namespace springcheck {

/// What there is to say of an option, for help, completion and manual pages.
struct OptionText {
  std::vector<std::string> names;  // "-h", "--help"; of a positional one "SCENE"
  std::string type;                // see options.hpp; empty of a flag
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

CommandText text_of(const Command& command);

/// "springcheck sweep SWEEP --out FILE [OPTIONS]".
std::string usage_of(const CommandText& command);

/// The groups of options that are not positional: their headings in the order of the
/// first option of each, those without a group of their own last, of whom there are some
/// in every command.
std::vector<std::string> groups_of(const CommandText& command);

/// The words that complete a value of the type, with those of the lists that it names;
/// nothing where it is any text.
std::vector<std::string> words_of_type(const std::string& type);

/// Whether files, or folders alone, complete it.
bool takes_files(const std::string& type);
bool takes_folders(const std::string& type);

}  // namespace springcheck
