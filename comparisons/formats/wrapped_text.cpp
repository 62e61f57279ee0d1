#include "comparisons/formats/wrapped_text.hpp"

#include <algorithm>

namespace springcheck {
namespace {

/// Of UTF-8: all bytes but those that continue a character.
std::size_t characters_in(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent,
                    std::size_t first) {
  std::string lines;
  std::size_t column = first;
  bool begins_line = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (word.empty()) continue;
    const std::size_t length = characters_in(word);
    if (!begins_line && column + 1 + length > width) {
      lines += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!begins_line) {
      lines += ' ';
      ++column;
    }
    lines += word;
    column += length;
    begins_line = false;
  }
  return lines;
}

std::string wrapped_entry(std::string_view name, std::string_view text,
                          std::size_t column, std::size_t width) {
  constexpr std::size_t margin = 2, indent_of_names = 6;
  std::string line(margin, ' ');
  line += wrapped(name, width, indent_of_names, margin);
  if (line.size() + margin > column)
    line += "\n" + std::string(column, ' ');
  else
    line.resize(column, ' ');
  return line + wrapped(text, width, column, column) + "\n";
}

}  // namespace springcheck
