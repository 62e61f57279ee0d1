#pragma once

#include "comparisons/command_line/declarations.hpp"

namespace springcheck {

/// What runs the other commands. Returns the program's exit status.
using Core = int (*)(int argc, char** argv);

/// The program as users know it: tells itself what is declared, all help among that, and
/// leaves the commands of `core`, which `declared` are of, to it. Returns the exit
/// status.
int front(int argc, char** argv, Declarations declared, Core core);

}  // namespace springcheck
