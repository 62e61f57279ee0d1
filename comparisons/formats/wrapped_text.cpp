#include "comparisons/formats/wrapped_text.hpp"

#include <utf8.h>

#include <algorithm>

namespace springcheck {
namespace {

std::size_t longest_word_in(std::string_view text) {
  std::size_t longest = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    longest = std::max(longest, characters_in(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return longest;
}

}  // namespace

std::size_t characters_in(std::string_view text) {
  const std::string sound = utf8::replace_invalid(text);
  return static_cast<std::size_t>(utf8::distance(sound.begin(), sound.end()));
}

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
  const std::string line =
      std::string(margin, ' ') + wrapped(name, width, indent_of_names, margin);
  const std::size_t longest = longest_word_in(text);
  if (column + longest > width)  // below the name there is room, if anywhere
    column = std::max(2 * margin, width - std::min(width, longest));
  const std::size_t length = characters_in(line);
  const std::string blanks = length + margin > column ? "\n" + std::string(column, ' ')
                                                      : std::string(column - length, ' ');
  return line + blanks + wrapped(text, width, column, column) + "\n";
}

}  // namespace springcheck
