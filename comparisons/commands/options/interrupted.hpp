#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "comparisons/system/interruption.hpp"

namespace springcheck {

// What a command says where it is interrupted.

/// What was complete is in the file, or nowhere, and the same command goes on from there.
BeforeInterruption tell_that_it_goes_on(const std::optional<std::filesystem::path>& file);

/// What was complete is in the file, or nowhere; `how` is how to go on from there.
BeforeInterruption tell_what_is_kept(const std::optional<std::filesystem::path>& file,
                                     const std::string& how = {});

}  // namespace springcheck
