#pragma once

#include <string_view>

namespace springcheck {

/// What runs the other commands. Returns the program's exit status.
using Core = int (*)(int argc, char** argv);

/// The program as users know it: tells itself what is declared, all help among that, and
/// leaves the commands of `core` to it, whose declarations are given as text_of() writes
/// them. Returns the exit status.
int front(int argc, char** argv, std::string_view declarations_of_core, Core core);

}  // namespace springcheck
