#pragma once

namespace springcheck {

/// The program: runs the command that the arguments name. Returns its exit status.
int command_line(int argc, char** argv);

}  // namespace springcheck
