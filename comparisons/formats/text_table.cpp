#include "comparisons/formats/text_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace springcheck {
namespace {

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char c : cell) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

/// A bar ends a cell of GitHub's tables, and a line's end the table.
std::string markdown_cell(const std::string& cell) {
  std::string text;
  for (const char c : cell) {
    if (c == '|') text += '\\';
    text += c == '\n' || c == '\r' ? ' ' : c;
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

std::string in_columns(const TextLines& lines, const std::vector<Align>& alignment) {
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i)
      widths[i] = std::max(widths[i], line[i].size());
  std::string text;
  for (const auto& line : lines) {
    std::string row;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool is_left = i < alignment.size() ? alignment[i] == Align::left : i == 0;
      row += i == 0 ? "" : "  ";
      row += is_left ? fmt::format("{:<{}}", line[i], widths[i])
                     : fmt::format("{:>{}}", line[i], widths[i]);
    }
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
  return text;
}

std::string markdown_text(const TextLines& lines, const TableText& text) {
  std::string all = fmt::format("## {}\n\n", text.title);
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
