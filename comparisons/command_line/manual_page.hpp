#pragma once

#include <span>
#include <string>

#include "comparisons/command_line/command_text.hpp"

namespace springcheck {

/// Manual pages, as man reads them: springcheck-COMMAND(1) of a command, springcheck(1)
/// of all.
std::string manual_page(const CommandText& command);
std::string manual_page(std::span<const CommandText> commands);

}  // namespace springcheck
