#pragma once

#include <string_view>
#include <vector>

#include "comparisons/command_line/command.hpp"
#include "comparisons/command_line/declarations.hpp"

namespace springcheck {

// The commands that tell what is declared, each in the file of its name. The declarations
// are read when one acts, and have to live till then.
Command list_command(const Declarations& all);
Command help_command(const Declarations& all);
Command completion_command(const Declarations& all);
Command manual_command(const Declarations& all);

/// All of them, in the order in which help tells them.
std::vector<Command> front_commands(const Declarations& all);

/// Adds their texts to the declarations that they tell.
void add_front_commands(Declarations& all);

/// Prints what `springcheck help NAME` does; without a name what there is. Throws
/// InputError where there is none of that name.
void print_help(std::string_view name, const Declarations& all);

}  // namespace springcheck
