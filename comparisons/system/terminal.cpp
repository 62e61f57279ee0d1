#include "comparisons/system/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <charconv>
#include <cstdlib>
#include <string_view>

namespace springcheck {
namespace {

std::string_view environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

/// 0 of any other text.
std::size_t number_in(std::string_view text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && stop == end ? number : 0;
}

bool output_is_terminal() {
  return isatty(STDOUT_FILENO) != 0;
}

}  // namespace

std::optional<std::size_t> columns_of_output() {
  if (const std::size_t columns = number_in(environment("COLUMNS"))) return columns;
  winsize size{};
  if (output_is_terminal() && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 &&
      size.ws_col > 0)
    return size.ws_col;
  return std::nullopt;
}

bool declines_colours() {
  return !environment("NO_COLOR").empty();
}

bool shows_colours() {
  const std::string_view terminal = environment("TERM");
  return output_is_terminal() && !terminal.empty() && terminal != "dumb" &&
         !declines_colours();
}

}  // namespace springcheck
