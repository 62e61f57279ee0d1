#include "comparisons/formats/latex_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <sstream>

#include "comparisons/formats/latex_escape.hpp"

namespace springcheck {
namespace {

constexpr std::size_t rows_of_a_float = 40, rows_of_a_sideways_float = 26;
// Width in characters, which are 5.5 points high then on a page 345 points wide.
constexpr std::size_t widest_upright = 120;
constexpr std::size_t widest_text = 30;  // [characters], longer ones are broken
constexpr std::size_t head_width = 12;   // [characters], broken at blanks

/// Whether a cell is a number, as "-0.31", "5 %" and "1e-5" are; what has no digit is
/// none.
bool is_number(const std::string& cell) {
  std::istringstream words(cell);
  double value = 0;
  std::string unit, further;
  return static_cast<bool>(words >> value) && (words.eof() || words.get() == ' ') &&
         (!(words >> unit) || !(words >> further));
}

/// Whether a column has more numbers than texts, which may stand where a number is
/// lacking.
bool is_column_of_numbers(const TextLines& lines, std::size_t column) {
  std::ptrdiff_t numbers = 0, texts = 0;
  for (const auto& line : std::span(lines).subspan(1))
    if (!line[column].empty()) ++(is_number(line[column]) ? numbers : texts);
  return numbers > texts;
}

/// The text as a line may begin with it: after a line's end LaTeX would take a bracket or
/// an asterisk for its argument.
std::string at_line_start(const std::string& text) {
  return text.starts_with('[') || text.starts_with('*') ? "{}" + text : text;
}

/// A head of several short lines.
std::string head_cell(const std::string& head, bool is_number) {
  std::vector<std::string> rows(1);
  std::istringstream words(head);
  for (std::string word; words >> word;) {
    if (!rows.back().empty() && rows.back().size() + 1 + word.size() > head_width)
      rows.emplace_back();
    rows.back() += (rows.back().empty() ? "" : " ") + word;
  }
  for (std::string& row : rows) row = at_line_start(latex_escaped(row));
  if (rows.size() == 1) return rows.front();
  return fmt::format("\\shortstack[{}]{{{}}}", is_number ? 'r' : 'l',
                     fmt::join(rows, "\\\\"));
}

std::string body_cell(const std::string& cell) {
  const bool is_negative = cell.starts_with('-') && is_number(cell);
  return is_negative ? "$-$" + latex_escaped(cell.substr(1)) : latex_escaped(cell);
}

std::string superscript(const std::string& marks) {
  return marks.empty() ? "" : "\\textsuperscript{" + marks + "}";
}

std::string row_text(const std::vector<std::string>& cells) {
  return "  " + at_line_start(fmt::format("{}", fmt::join(cells, " & "))) + " \\\\\n";
}

/// What a table says once instead of in every row.
struct Condensed {
  TextLines lines;
  std::vector<std::string> cases{};  // of the rows, empty without a column of them
  std::string constants{};           // "mesh 10x10x10, nu 0.25"
};

Condensed condensed(TextLines lines) {
  Condensed shorter{.lines = std::move(lines)};
  shorter.cases.resize(shorter.lines.size() - 1);
  TextLines& rows = shorter.lines;
  for (std::size_t column = rows[0].size(); column-- > 0;) {
    const std::string& head = rows[0][column];
    const std::string value = rows[1][column];
    const bool is_case = head == "case";
    const bool is_constant =
        rows.size() > 3 && !value.empty() && head != "notes" &&
        std::all_of(rows.begin() + 1, rows.end(),
                    [&](const auto& row) { return row[column] == value; });
    if (!is_case && !is_constant) continue;
    if (is_case)
      for (std::size_t row = 1; row < rows.size(); ++row)
        shorter.cases[row - 1] = rows[row][column];
    else
      shorter.constants = head + " " + value + (shorter.constants.empty() ? "" : ", ") +
                          shorter.constants;
    for (auto& row : rows) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
  }
  return shorter;
}

/// The longest word-broken head or cell of a column.
std::size_t column_width(const TextLines& lines, std::size_t column) {
  std::size_t longest = std::min(lines[0][column].size(), head_width);
  for (const auto& line : std::span(lines).subspan(1))
    longest = std::max(longest, line[column].size());
  return std::min(longest, widest_text);
}

bool is_wide(const TextLines& lines) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < lines[0].size(); ++i) width += column_width(lines, i) + 1;
  return width > widest_upright;
}

std::string alignment_of(const TextLines& lines, std::size_t column, bool is_numbers) {
  if (is_numbers) return "r";
  const bool is_broken = column_width(lines, column) == widest_text;
  return is_broken ? "p{14em}" : "l";
}

/// The tabular of the rows from `first` to `last`, excluded.
std::string tabular(const TextLines& lines, const std::vector<std::string>& cases,
                    std::size_t first, std::size_t last) {
  std::string alignment;
  std::vector<std::string> heads;
  for (std::size_t i = 0; i < lines[0].size(); ++i) {
    const bool numbers = is_column_of_numbers(lines, i) && lines[0][i] != "notes";
    alignment += alignment_of(lines, i, numbers);
    heads.push_back(head_cell(lines[0][i], numbers));
  }
  std::string text = fmt::format(
      "\\begin{{adjustbox}}{{max "
      "width=\\linewidth}}\n\\begin{{tabular}}{{@{{}}{}@{{}}}}\n"
      "  \\toprule\n{}  \\midrule\n",
      alignment, row_text(heads));
  for (std::size_t row = first; row < last; ++row) {
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < lines[row].size(); ++i)
      cells.push_back(lines[0][i] == "notes" ? superscript(lines[row][i])
                                             : body_cell(lines[row][i]));
    text += row_text(cells);
    if (const std::string& key = cases[row - 1]; !key.empty())
      text.replace(text.size() - 1, 1, " % case " + key + "\n");
  }
  return text + "  \\bottomrule\n\\end{tabular}\n\\end{adjustbox}\n";
}

std::string notes_below(const TableText& text) {
  std::string all;
  for (const std::string& note : text.notes)
    all += "\\par\\smallskip " + latex_escaped(note) + "\n";
  for (std::size_t i = 0; i < text.footnotes.size(); ++i)
    all += fmt::format("\\par\\smallskip {} {}\n", superscript(std::to_string(i + 1)),
                       latex_escaped(text.footnotes[i]));
  return all.empty() ? all : "\\raggedright\n" + all;
}

}  // namespace

std::string latex_text(const TextLines& table, const TableText& table_text) {
  const auto [lines, cases, constants] = condensed(table);
  TableText text = table_text;
  if (!constants.empty())
    text.notes.insert(text.notes.begin(), "In all rows: " + constants + ".");
  // The table is rotated by a quarter turn where the page's width is too little.
  const bool is_sideways = is_wide(lines);
  const std::string packages = is_sideways ? "booktabs,adjustbox,rotating"
                                           : "booktabs,adjustbox",
                    environment = is_sideways ? "sidewaystable" : "table",
                    height = is_sideways ? "\\pagewidth" : ".85\\textheight";
  std::string all = "% needs \\usepackage{" + packages + "}\n";
  // Within the float \textwidth is the height of the page.
  if (is_sideways) all += "\\begingroup\\edef\\pagewidth{\\the\\dimexpr.85\\textwidth}\n";
  const std::size_t rows = lines.size() - 1;
  const std::size_t most = is_sideways ? rows_of_a_sideways_float : rows_of_a_float;
  const std::size_t floats = std::max<std::size_t>(1, (rows + most - 1) / most);
  for (std::size_t part = 0; part < floats; ++part) {
    const std::string caption =
        part == 0 ? fmt::format("\\caption{{{}}}", latex_escaped(text.title))
                  : "\\tablename~\\thetable, continued\\par\\smallskip";
    all += fmt::format(
        "\\begin{{{0}}}[htbp]\n\\centering\n{1}\n"
        // What is higher than the page, by its notes, is scaled too.
        "\\begin{{adjustbox}}{{max totalheight={2}}}\n"
        "\\begin{{minipage}}{{\\linewidth}}\n\\footnotesize\n\\centering\n\\setlength{{"
        "\\tabcolsep}}{{3pt}}\n{3}{4}"
        "\\end{{minipage}}\n\\end{{adjustbox}}\n\\end{{{0}}}\n{5}",
        environment, caption, height,
        tabular(lines, cases, 1 + rows * part / floats, 1 + rows * (part + 1) / floats),
        part + 1 == floats ? notes_below(text) : "",
        // LaTeX keeps few floats that found no place yet.
        part + 1 == floats ? "" : "\\clearpage\n");
  }
  return is_sideways ? all + "\\endgroup\n" : all;
}

}  // namespace springcheck
