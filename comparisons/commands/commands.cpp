#include "comparisons/commands/commands.hpp"

#include "comparisons/settings/suggestion.hpp"

namespace springcheck {

std::vector<Command> all_commands() {
  std::vector<Command> commands;
  for (const auto& make : every_command) commands.push_back(make());
  return commands;
}

std::vector<std::string_view> command_names() {
  std::vector<std::string_view> names;
  for (const auto& make : every_command) names.push_back(make().name);
  return names;
}

Command command_named(std::string_view name) {
  for (const auto& make : every_command)
    if (Command command = make(); command.name == name) return command;
  refuse_name("springcheck", "command", name, command_names());
}

}  // namespace springcheck
