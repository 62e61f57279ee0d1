#pragma once

#include <cstddef>
#include <optional>

namespace springcheck {

/// The characters of a line of standard output, as COLUMNS says or the terminal; nothing
/// where it is none.
std::optional<std::size_t> columns_of_output();

/// Whether standard output is a terminal that shows colours and the user did not decline
/// them by NO_COLOR, see no-color.org.
bool shows_colours();

}  // namespace springcheck
