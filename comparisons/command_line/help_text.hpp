#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "comparisons/command_line/command_text.hpp"

namespace springcheck {

/// What `springcheck COMMAND --help` prints: usage, examples, and the options in their
/// groups, in lines of at most `width` characters.
std::string help_text(const CommandText& command, std::size_t width);

/// What the program can do: the commands, and three to try.
std::string overview_text(std::span<const Command> commands, std::size_t width);

/// The characters of a line of standard output: as COLUMNS says, or the terminal; 80
/// elsewhere. From 40 to 100, since longer lines are hard to read.
std::size_t width_of_output();

}  // namespace springcheck
