#pragma once

#include "comparisons/formats/text_table.hpp"

namespace springcheck {

/// What standard output is shown on: as wide as the terminal, or COLUMNS, and with these
/// colours of cells where it has any.
Screen screen_of_output(
    std::function<Colour(std::string_view head, std::string_view cell)> colour_of = {});

}  // namespace springcheck
