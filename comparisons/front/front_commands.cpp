#include "comparisons/front/front_commands.hpp"

#include "comparisons/formats/capitals.hpp"

namespace springcheck {

std::vector<Command> front_commands(const Declarations& all) {
  return {list_command(all), help_command(all), completion_command(all),
          manual_command(all)};
}

void add_front_commands(Declarations& all) {
  const std::vector<Command> commands = front_commands(all);
  const std::size_t first = all.commands.size();
  for (const Command& command : commands)
    all.commands.push_back({.name = std::string(command.name),
                            .summary = {},
                            .description = {},
                            .examples = {},
                            .options = {},
                            .footer = {}});
  // COMMAND stands for the names of all, those above among them.
  const auto names_behind = [&all](const std::string& capitals) {
    std::vector<std::string> names;
    if (capitals == "COMMAND")
      for (const std::string_view name : command_names(all)) names.emplace_back(name);
    return names;
  };
  std::vector<CommandText> texts;
  for (const Command& command : commands) texts.push_back(text_of(command, names_behind));
  std::ranges::copy(texts, all.commands.begin() + static_cast<std::ptrdiff_t>(first));
}

}  // namespace springcheck
