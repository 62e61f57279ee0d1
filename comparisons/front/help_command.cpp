#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "comparisons/command_line/help_text.hpp"
#include "comparisons/front/front_commands.hpp"

namespace springcheck {

void print_help(std::string_view name, const Declarations& all) {
  const std::size_t width = width_of_lines().value_or(80);
  fmt::print("{}", name.empty() ? overview_text(all.commands, width)
                                : help_text(command_named(name, all), width));
}

Command help_command(const Declarations& all) {
  const auto declare = [&all](CLI::App& parser) -> Action {
    const auto name = std::make_shared<std::string>();
    parser.add_option("command", *name, "whose options are told (default: all commands)")
        ->type_name("COMMAND");
    return [name, &all] {
      print_help(*name, all);
      return ExitStatus::done;
    };
  };
  return {.name = "help",
          .summary = "Tell what there is, or the options of a command",
          .description = "",
          .examples = {{"springcheck help run", "the same as springcheck run --help"}},
          .declare = declare};
}

}  // namespace springcheck
