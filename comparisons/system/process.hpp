#pragma once

#include <string>
#include <vector>

namespace springcheck {

/// Runs a program, whose path is the first of the words, and waits for its end. Where
/// this program is interrupted meanwhile, that one gets a SIGTERM and ends before.
/// Returns its exit status, or 128 and the number of the signal that ended it. Throws
/// std::runtime_error where it cannot be started.
int run_program(const std::vector<std::string>& words);

}  // namespace springcheck
