#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace springcheck {

/// A head line and rows of equal length.
using TextLines = std::vector<std::vector<std::string>>;

/// What tables say below their rows.
struct TableText {
  std::string title;
  std::vector<std::string> notes;      // paragraphs on the table as a whole
  std::vector<std::string> footnotes;  // numbered from 1
};

/// The lines without the columns that hold nothing but `empty` in every row.
TextLines without_empty_columns(TextLines lines, const std::string& empty = {});

enum class Align { left, right };

/// Green, yellow and red on a terminal.
enum class Colour { usual, good, doubtful, bad };

/// The screen that lines are shown on.
struct Screen {
  std::optional<std::size_t> width{};  // of its lines; they may have any without
  /// The colour of a cell below a head, where there are colours.
  std::function<Colour(std::string_view head, std::string_view cell)> colour_of{};
};

/// Lines in columns, two blanks between. Where nothing else is said, the first stands to
/// the left and the others to the right. What is wider than the screen is turned: heads
/// to the left, and beside them as many lines as there is room for, one at least; the
/// others below in the same way.
std::string in_columns(const TextLines& lines, const std::vector<Align>& alignment = {},
                       const Screen& screen = {});

/// A text in lines that are as wide as the screen, without a line end after the last one.
std::string in_lines(std::string_view text, const Screen& screen);

std::string markdown_text(const TextLines& lines, const TableText& text);

/// Comma-separated values by RFC 4180.
std::string csv_text(const TextLines& lines);

/// A number in fmt's `format`; zero without the sign of what was rounded to it.
std::string rounded(const std::string& format, double value);

}  // namespace springcheck
