#include "comparisons/command_line/screen.hpp"

#include "comparisons/system/terminal.hpp"

namespace springcheck {

Screen screen_of_output(
    std::function<Colour(std::string_view head, std::string_view cell)> colour_of) {
  return {.width = columns_of_output(),
          .colour_of = shows_colours() ? std::move(colour_of) : nullptr};
}

}  // namespace springcheck
