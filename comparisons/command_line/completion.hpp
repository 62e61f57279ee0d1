#pragma once

#include <span>
#include <string>

#include "comparisons/command_line/command_text.hpp"
#include "comparisons/names/named.hpp"

namespace springcheck {

enum class Shell { bash, zsh, fish };

template <>
inline constexpr std::array value_names<Shell>{
    Named{Shell::bash, "bash"}, Named{Shell::zsh, "zsh"}, Named{Shell::fish, "fish"}};

/// A script by which the shell completes commands, their options, and the values of
/// those: names that there are, files and folders.
std::string completion_script(Shell shell, std::span<const CommandText> commands);

}  // namespace springcheck
