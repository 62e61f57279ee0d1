#include "comparisons/command_line/command_text.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "comparisons/formats/capitals.hpp"

namespace springcheck {
namespace {

const std::string without_group = "Options";  // CLI11's word

std::vector<std::string> parts_of(const std::string& type) {
  std::vector<std::string> parts;
  for (std::size_t first = 0; first <= type.size();) {
    const std::size_t end = std::min(type.find('|', first), type.size());
    parts.push_back(type.substr(first, end - first));
    first = end + 1;
  }
  return parts;
}

/// Whether a part of a type names a list, which is in capitals; E alone is a value.
bool names_a_list(const std::string& part) {
  return part.size() > 1 && std::isupper(static_cast<unsigned char>(part.front())) != 0;
}

std::vector<std::string> words_of_type(const std::string& type,
                                       const NamesBehind& names_behind) {
  std::vector<std::string> words;
  for (const std::string& part : parts_of(type)) {
    if (names_a_list(part))
      std::ranges::copy(names_behind(part), std::back_inserter(words));
    else if (!part.empty())
      words.push_back(part);
  }
  return words;
}

OptionText text_of(const CLI::Option& option, const NamesBehind& names_behind) {
  OptionText text{.names = {},
                  .type = option.get_items_expected() == 0 ? "" : option.get_type_name(),
                  .words = {},
                  .description = option.get_description(),
                  .group = capitalised(option.get_group()),
                  .is_positional = option.get_positional(),
                  .is_required = option.get_required(),
                  .may_be_repeated = option.get_items_expected_max() > 1};
  if (text.is_positional)
    text.names = {in_capitals(option.get_single_name())};
  else {
    for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  }
  text.words = words_of_type(text.type, names_behind);
  if (const std::string usual = option.get_default_str(); !usual.empty())
    text.description += fmt::format(" (default {})", usual);
  return text;
}

}  // namespace

CommandText text_of(const Command& command, const NamesBehind& names_behind) {
  const DeclaredCommand declared(command);
  CommandText text{.name = std::string(command.name),
                   .summary = std::string(command.summary),
                   .description = std::string(command.description),
                   .examples = command.examples,
                   .options = {},
                   .footer = declared.parser.get_footer()};
  for (const CLI::Option* option : declared.parser.get_options())
    text.options.push_back(text_of(*option, names_behind));
  std::ranges::stable_partition(text.options, &OptionText::is_positional);
  return text;
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Example, words, what)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OptionText, names, type, words, description, group,
                                   is_positional, is_required, may_be_repeated)

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CommandText, name, summary, description, examples,
                                   options, footer)

nlohmann::json json_of(const CommandText& command) {
  return command;
}

CommandText command_text_from(const nlohmann::json& json) {
  return json.get<CommandText>();
}

std::string usage_of(const CommandText& command) {
  std::string usage = "springcheck " + command.name;
  for (const OptionText& option : command.options) {
    std::string part = option.names.back();
    if (!option.is_positional) {
      if (!option.is_required) continue;
      part += " " + option.type;
    }
    if (option.is_positional && option.may_be_repeated) part += "...";
    usage += option.is_required ? " " + part : fmt::format(" [{}]", part);
  }
  return usage + " [OPTIONS]";
}

std::vector<std::string> groups_of(const CommandText& command) {
  std::vector<std::string> groups;
  for (const OptionText& option : command.options)
    if (!option.is_positional && std::ranges::count(groups, option.group) == 0)
      groups.push_back(option.group);
  std::ranges::stable_partition(
      groups, [](const std::string& group) { return group != without_group; });
  return groups;
}

bool takes_files(const std::string& type) {
  return std::ranges::count(parts_of(type), "FILE") > 0;
}

bool takes_folders(const std::string& type) {
  return std::ranges::count(parts_of(type), "FOLDER") > 0;
}

}  // namespace springcheck
