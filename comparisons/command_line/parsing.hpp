#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/command_line/command.hpp"

namespace springcheck {

using Words = std::vector<std::string>;

/// The arguments behind the program's name. Throws InputError unless all are UTF-8: they
/// may come to stand in JSON and HDF5.
Words words_of(int argc, char** argv);

/// Takes --verbose, which may stand before the command; returns whether it stood there.
bool take_verbose(Words& words);

/// Reads the words behind a command into its options. Returns a status where there is
/// nothing more to do: the version was asked for, or the words were refused. Throws
/// InputError.
std::optional<ExitStatus> read_options(DeclaredCommand& command, Words words);

/// What main returns: the status that the program ends in, of its exceptions too, whose
/// messages go to stderr. What was printed must have arrived: a full disk or a closed
/// pipe is a failure.
int exit_status_of(const std::function<ExitStatus()>& program);

}  // namespace springcheck
