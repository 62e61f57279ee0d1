#include "comparisons/command_line/command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "comparisons/build_info/build_info.hpp"

namespace springcheck {

DeclaredCommand::DeclaredCommand(const Command& command)
    : parser("", std::string(command.name)) {
  action = command.declare(parser);
  parser.add_flag("--verbose", verbose, "log every Newton iteration to stderr");
  parser.set_version_flag(
      "--version", [] { return version_text(); }, "print the version");
  parser.set_help_flag("-h,--help", "print this help");
}

std::string version_text() {
  return fmt::format("springcheck {} ({})", build_info::version, build_info::commit);
}

}  // namespace springcheck
