#pragma once

#include <cstddef>
#include <optional>

namespace springcheck {

/// The characters of a line of standard output, as COLUMNS says or the terminal; nothing
/// where it is none.
std::optional<std::size_t> columns_of_output();

/// Whether the user wants none, by NO_COLOR (see no-color.org).
bool declines_colours();

/// Whether standard output is a terminal that shows colours, and they are not declined.
bool shows_colours();

}  // namespace springcheck
