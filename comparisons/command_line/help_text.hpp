#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "comparisons/command_line/command_text.hpp"

namespace springcheck {

/// What `springcheck COMMAND --help` prints: usage, examples, and the options in their
/// groups, in lines of at most `width` characters.
std::string help_text(const CommandText& command, std::size_t width);

/// What the program can do: the commands, and three to try.
std::string overview_text(std::span<const CommandText> commands, std::size_t width);

/// The characters of a line of text on standard output, as COLUMNS or the terminal says,
/// from 40 to 100, since longer lines are hard to read; nothing where it is no terminal.
std::optional<std::size_t> width_of_lines();

}  // namespace springcheck
