#include "comparisons/formats/text_table.hpp"

#include <fmt/color.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "comparisons/formats/wrapped_text.hpp"

namespace springcheck {
namespace {

constexpr std::size_t gap = 2;  // blanks between columns

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char c : cell) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

std::string in_one_line(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

/// A cell as Markdown: a bar ends a cell of GitHub's tables, and a line's end the table.
std::string markdown_cell(const std::string& cell) {
  std::string text;
  for (const char c : in_one_line(cell)) {
    if (c == '|') text += '\\';
    text += c;
  }
  return text;
}

std::vector<std::size_t> widths_of(const TextLines& lines) {
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i)
      widths[i] = std::max(widths[i], characters_in(line[i]));
  return widths;
}

/// The width of the lines in columns.
std::size_t width_of(const TextLines& lines) {
  const std::vector<std::size_t> widths = widths_of(lines);
  return std::accumulate(widths.begin(), widths.end(), gap * (widths.size() - 1));
}

Colour colour_on(const Screen& screen, const std::string& head, const std::string& cell) {
  return screen.colour_of ? screen.colour_of(head, cell) : Colour::usual;
}

std::string coloured(const std::string& text, Colour colour) {
  switch (colour) {
    case Colour::usual:
      return text;
    case Colour::good:
      return fmt::format(fg(fmt::terminal_color::green), "{}", text);
    case Colour::doubtful:
      return fmt::format(fg(fmt::terminal_color::yellow), "{}", text);
    case Colour::bad:
      return fmt::format(fg(fmt::terminal_color::red), "{}", text);
  }
  throw std::logic_error("a colour that is none");
}

/// A line with blanks that fill its columns, aligned(column) and coloured by
/// colour_of(column); none at its end.
template <class Aligned, class ColourOf>
std::string row_text(const std::vector<std::string>& line,
                     const std::vector<std::size_t>& widths, Aligned&& aligned,
                     ColourOf&& colour_of) {
  std::string text;
  std::size_t blanks = 0;  // that only come before another cell
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::size_t length = std::min(widths[i], characters_in(line[i]));
    const std::size_t fill = widths[i] - length;  // none behind one that has line ends
    const bool is_left = aligned(i) == Align::left;
    if (i > 0) blanks += gap;
    if (!is_left) blanks += fill;
    if (!line[i].empty()) {
      text += std::string(blanks, ' ') + coloured(line[i], colour_of(i));
      blanks = 0;
    }
    if (is_left) blanks += fill;
  }
  return text + "\n";
}

/// Heads and the lines from `first` to `last`, each a column.
TextLines turned(const TextLines& lines, std::size_t first, std::size_t last) {
  TextLines columns;
  for (std::size_t i = 0; i < lines.front().size(); ++i) {
    columns.push_back({lines.front()[i]});
    for (std::size_t line = first; line < last; ++line)
      columns.back().push_back(lines[line][i]);
  }
  return columns;
}

std::string in_turned_columns(const TextLines& lines, const Screen& screen) {
  std::string text;
  for (std::size_t first = 1; first < lines.size();) {
    std::size_t last = first + 1;
    while (last < lines.size() &&
           width_of(turned(lines, first, last + 1)) <= *screen.width)
      ++last;
    TextLines part = turned(lines, first, last);
    const std::vector<std::size_t> widths = widths_of(part);
    if (const std::size_t indent = widths[0] + gap; last == first + 1)
      for (auto& line : part) line[1] = wrapped(line[1], *screen.width, indent, indent);
    if (first > 1) text += "\n";
    for (const auto& line : part)
      text += row_text(
          line, widths, [](std::size_t) { return Align::left; },
          [&](std::size_t column) {
            return column == 0 ? Colour::usual
                               : colour_on(screen, line.front(), line[column]);
          });
    first = last;
  }
  return text;
}

}  // namespace

TextLines without_empty_columns(TextLines lines, const std::string& empty) {
  for (std::size_t column = lines.front().size(); column-- > 0;) {
    const bool is_empty = std::all_of(lines.begin() + 1, lines.end(),
                                      [&](auto& line) { return line[column] == empty; });
    if (is_empty)
      for (auto& line : lines)
        line.erase(line.begin() + static_cast<std::ptrdiff_t>(column));
  }
  return lines;
}

std::string in_columns(const TextLines& lines, const std::vector<Align>& alignment,
                       const Screen& screen) {
  const auto aligned = [&](std::size_t column) {
    return column < alignment.size() ? alignment[column]
           : column == 0             ? Align::left
                                     : Align::right;
  };
  if (!screen.width || lines.size() < 2 || width_of(lines) <= *screen.width) {
    std::string text;
    const std::vector<std::size_t> widths = widths_of(lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto colour_of = [&](std::size_t column) {
        return i == 0 ? Colour::usual
                      : colour_on(screen, lines[0][column], lines[i][column]);
      };
      text += row_text(lines[i], widths, aligned, colour_of);
    }
    return text;
  }
  return in_turned_columns(lines, screen);
}

std::string in_lines(std::string_view text, const Screen& screen) {
  if (!screen.width) return std::string(text);
  const std::size_t indent = std::min(text.find_first_not_of(' '), text.size());
  return std::string(indent, ' ') + wrapped(text, *screen.width, indent, indent);
}

std::string markdown_text(const TextLines& lines, const TableText& text) {
  std::string all = fmt::format("## {}\n\n", in_one_line(text.title));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const std::string& cell : lines[i])
      all += fmt::format("| {} ", markdown_cell(cell));
    all += "|\n";
    if (i > 0) continue;
    for (std::size_t column = 0; column < lines[0].size(); ++column) all += "| --- ";
    all += "|\n";
  }
  for (const std::string& note : text.notes) all += "\n" + note + "\n";
  if (!text.footnotes.empty()) all += "\n";
  for (std::size_t i = 0; i < text.footnotes.size(); ++i)
    all += fmt::format("{}. {}\n", i + 1, text.footnotes[i]);
  return all;
}

std::string csv_text(const TextLines& lines) {
  std::string text;
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i)
      text += quoted(line[i]) + (i + 1 < line.size() ? "," : "\n");
  return text;
}

std::string rounded(const std::string& format, double value) {
  const std::string text = fmt::format(fmt::runtime(format), value);
  if (!std::isfinite(value)) return text;
  const bool is_zero = text.find_first_of("123456789") == std::string::npos;
  return is_zero ? fmt::format(fmt::runtime(format), 0.) : text;
}

}  // namespace springcheck
