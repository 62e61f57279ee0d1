#pragma once

#include <string>
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

/// Lines in columns, two blanks between. Where nothing else is said, the first stands to
/// the left and the others to the right.
enum class Align { left, right };
std::string in_columns(const TextLines& lines, const std::vector<Align>& alignment = {});

std::string markdown_text(const TextLines& lines, const TableText& text);

/// Comma-separated values by RFC 4180.
std::string csv_text(const TextLines& lines);

/// A number in fmt's `format`; zero without the sign of what was rounded to it.
std::string rounded(const std::string& format, double value);

}  // namespace springcheck
