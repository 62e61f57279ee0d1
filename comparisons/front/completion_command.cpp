#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "comparisons/command_line/completion.hpp"
#include "comparisons/command_line/options.hpp"
#include "comparisons/front/front_commands.hpp"

namespace springcheck {

Command completion_command(const Declarations& all) {
  const auto declare = [&all](CLI::App& parser) -> Action {
    const auto shell = std::make_shared<Shell>();
    add_choice<Shell>(parser, "shell", *shell, "whose script it is")->required();
    return [shell, &all] {
      fmt::print("{}", completion_script(*shell, all.commands));
      return ExitStatus::done;
    };
  };
  return {.name = "completion",
          .summary = "Print a script by which a shell completes commands",
          .description =
              "The installed package has these scripts already; they are for a "
              "program in a build folder.",
          .examples = {{"eval \"$(springcheck completion bash)\"",
                        "in ~/.bashrc; the same for zsh, after compinit, in ~/.zshrc"},
                       {"springcheck completion fish | source",
                        "in ~/.config/fish/config.fish"}},
          .declare = declare};
}

}  // namespace springcheck
