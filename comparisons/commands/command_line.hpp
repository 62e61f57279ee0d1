#pragma once

namespace springcheck {

/// Runs the command that the arguments name, one of this room. Returns its exit status.
int command_line(int argc, char** argv);

}  // namespace springcheck
