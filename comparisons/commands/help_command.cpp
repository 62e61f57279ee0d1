#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "comparisons/command_line/help_text.hpp"
#include "comparisons/command_line/options.hpp"
#include "comparisons/commands/commands.hpp"

namespace springcheck {
namespace {

Action declare_help(CLI::App& parser) {
  const auto name = std::make_shared<std::string>();
  parser.add_option("command", *name, "whose options are told (default: all commands)")
      ->type_name(alternatives(command_names()));
  return [name] {
    print_help(*name);
    return ExitStatus::done;
  };
}

}  // namespace

void print_help(std::string_view name) {
  const std::size_t width = width_of_output();
  fmt::print("{}", name.empty() ? overview_text(all_commands(), width)
                                : help_text(text_of(command_named(name)), width));
}

Command help_command() {
  return {.name = "help",
          .summary = "Tell what there is, or the options of a command",
          .description = "",
          .examples = {{"springcheck help run", "the same as springcheck run --help"}},
          .simulates = false,
          .declare = declare_help};
}

}  // namespace springcheck
