#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/command_line/exit_status.hpp"

namespace springcheck {

struct Example {
  std::string words;  // "springcheck run compression"
  std::string what;
};

/// What a command does, once its options have been read.
using Action = std::function<ExitStatus()>;

/// A command of the program. It is declared once, in the file of its name; the parser,
/// help, completion, manual pages and the documentation read it there.
struct Command {
  std::string_view name;
  std::string_view summary;      // a line of the list of commands, without a full stop
  std::string_view description;  // further sentences of its help; may be empty
  std::vector<Example> examples;
  /// Adds its options to the parser. What they are read into belongs to the action.
  std::function<Action(CLI::App& parser)> declare;
};

/// "springcheck 0.2.0 (commit)".
std::string version_text();

/// A command with its options, which the parser reads.
struct DeclaredCommand {
  explicit DeclaredCommand(const Command& command);
  DeclaredCommand(const DeclaredCommand&) = delete;  // the parser writes into `verbose`
  DeclaredCommand& operator=(const DeclaredCommand&) = delete;

  CLI::App parser;
  Action action;
  bool verbose = false;
};

}  // namespace springcheck
