#include "comparisons/command_line/command.hpp"

#include <CLI/CLI.hpp>
#include <string>

namespace springcheck {

DeclaredCommand::DeclaredCommand(const Command& its_command)
    : command(its_command), parser("", std::string(its_command.name)) {
  action = command.declare(parser);
  parser.add_flag("--verbose", verbose, "log every Newton iteration to stderr");
  parser.set_help_flag("-h,--help", "print this help");
}

}  // namespace springcheck
