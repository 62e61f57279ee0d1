#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "comparisons/command_line/completion.hpp"
#include "comparisons/command_line/options.hpp"
#include "comparisons/commands/commands.hpp"

namespace springcheck {
namespace {

Action declare_completion(CLI::App& parser) {
  const auto shell = std::make_shared<Shell>();
  add_choice<Shell>(parser, "shell", *shell, "whose script it is")->required();
  return [shell] {
    std::vector<CommandText> texts;
    for (const Command& command : all_commands()) texts.push_back(text_of(command));
    fmt::print("{}", completion_script(*shell, texts));
    return ExitStatus::done;
  };
}

}  // namespace

Command completion_command() {
  return {.name = "completion",
          .summary = "Print a script by which a shell completes commands",
          .description =
              "The installed package has these scripts already; they are for a "
              "program in a build folder.",
          .examples = {{"eval \"$(springcheck completion bash)\"",
                        "in ~/.bashrc; the same for zsh, after compinit, in ~/.zshrc"},
                       {"springcheck completion fish | source",
                        "in ~/.config/fish/config.fish"}},
          .simulates = false,
          .declare = declare_completion};
}

}  // namespace springcheck
