#include "comparisons/command_line/declarations.hpp"

#include <algorithm>

#include "comparisons/names/suggestion.hpp"

namespace springcheck {

std::string text_of(const Declarations& declarations) {
  nlohmann::json commands = nlohmann::json::array();
  for (const CommandText& command : declarations.commands)
    commands.push_back(json_of(command));
  return nlohmann::ordered_json{{"commands", commands}, {"lists", declarations.lists}}
      .dump();
}

Declarations declarations_from(std::string_view text) {
  const auto json = nlohmann::ordered_json::parse(text);
  Declarations declarations{.commands = {}, .lists = json.at("lists")};
  for (const auto& command : json.at("commands"))
    declarations.commands.push_back(command_text_from(command));
  return declarations;
}

std::vector<std::string_view> command_names(const Declarations& declarations) {
  std::vector<std::string_view> names;
  for (const CommandText& command : declarations.commands) names.push_back(command.name);
  return names;
}

const CommandText& command_named(std::string_view name,
                                 const Declarations& declarations) {
  const auto& commands = declarations.commands;
  const auto found = std::ranges::find(commands, name, &CommandText::name);
  if (found == commands.end())
    refuse_name("springcheck", "command", name, command_names(declarations));
  return *found;
}

}  // namespace springcheck
