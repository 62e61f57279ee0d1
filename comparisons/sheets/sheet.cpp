#include "comparisons/sheets/sheet.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/sheets/latex_table.hpp"
#include "comparisons/sheets/text_table.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> footnotes(const Sheet& sheet) {
  std::vector<std::string> notes;
  for (const SheetRow& row : sheet.rows)
    for (const std::string& note : row.notes)
      if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
  return notes;
}

/// Digits of a number of the column.
std::string with_sign(const Column& column, const std::string& digits) {
  return column.is_signed && digits.front() != '-' ? "+" + digits : digits;
}

/// Head line and rows; shown(column, cell) is a cell's text.
template <class Shown, class Notes, class Cases>
TextLines lines_of(const Sheet& sheet, Shown&& shown, Notes&& notes, Cases&& cases) {
  TextLines lines(1);
  for (const Column& column : sheet.columns) lines[0].push_back(column.heading);
  lines[0].insert(lines[0].end(), {"notes", "case"});
  for (const SheetRow& row : sheet.rows) {
    std::vector<std::string> line;
    for (std::size_t i = 0; i < sheet.columns.size(); ++i) {
      const Cell& cell = row.cells.at(i);
      line.push_back(
          cell.number ? with_sign(sheet.columns[i], shown(sheet.columns[i], *cell.number))
                      : cell.text);
    }
    line.insert(line.end(), {notes(row), cases(row)});
    lines.push_back(std::move(line));
  }
  return lines;
}

/// Heads and rounded rows, without the columns that are empty in every row.
TextLines grid(const Sheet& sheet, const std::vector<std::string>& notes) {
  const auto marks = [&](const SheetRow& row) {
    std::vector<std::ptrdiff_t> numbers;
    for (const std::string& note : row.notes)
      numbers.push_back(std::ranges::find(notes, note) - notes.begin() + 1);
    return fmt::format("{}", fmt::join(numbers, " "));
  };
  const auto key = [](const SheetRow& row) {
    return row.cases.empty() ? std::string() : row.cases.front().substr(0, 12);
  };
  return without_empty_columns(lines_of(
      sheet,
      [](const Column& column, double number) { return rounded(column.format, number); },
      marks, key));
}

std::string csv(const Sheet& sheet) {
  return csv_text(lines_of(
      sheet, [](const Column&, double number) { return fmt::format("{}", number); },
      [](const SheetRow& row) { return fmt::format("{}", fmt::join(row.notes, " ")); },
      [](const SheetRow& row) { return fmt::format("{}", fmt::join(row.cases, " ")); }));
}

Json json(const Column& column, const Cell& cell) {
  if (!column.format.empty()) return cell.number ? Json(*cell.number) : Json();
  return cell.text.empty() ? Json() : Json(cell.text);
}

std::string json_text(const Sheet& sheet) {
  Json rows = Json::array();
  for (const SheetRow& row : sheet.rows) {
    Json out;
    for (std::size_t i = 0; i < sheet.columns.size(); ++i)
      out[sheet.columns[i].key] = json(sheet.columns[i], row.cells[i]);
    out["notes"] = row.notes;
    out["case"] = row.cases.empty() ? Json() : Json(row.cases.front());
    out["cases"] = row.cases;
    if (!row.part.empty()) out["part"] = row.part;
    rows.push_back(out);
  }
  Json columns = Json::array();
  for (const Column& column : sheet.columns)
    columns.push_back({{"key", column.key},
                       {"heading", column.heading},
                       {"format", column.format.empty() ? Json() : Json(column.format)}});
  const Json document{{"springcheck", build_info::version},
                      {"table", sheet.name},
                      {"title", sheet.title},
                      {"columns", columns},
                      {"rows", rows},
                      {"notes", sheet.notes}};
  return document.dump(2) + "\n";
}

}  // namespace

std::string format_sheet(const Sheet& sheet, TableFormat format) {
  const std::vector<std::string> notes = footnotes(sheet);
  const TableText text{.title = sheet.title, .notes = sheet.notes, .footnotes = notes};
  switch (format) {
    case TableFormat::markdown:
      return markdown_text(grid(sheet, notes), text);
    case TableFormat::latex:
      return latex_text(grid(sheet, notes), text);
    case TableFormat::csv:
      return csv(sheet);
    case TableFormat::json:
      return json_text(sheet);
  }
  return {};
}

std::string format_sheets(const std::vector<Sheet>& sheets, TableFormat format) {
  const bool is_json = format == TableFormat::json;
  std::string text = is_json ? "[\n" : "";
  for (std::size_t i = 0; i < sheets.size(); ++i)
    text += (i == 0 ? "" : is_json ? ",\n" : "\n") + format_sheet(sheets[i], format);
  return text + (is_json ? "]\n" : "");
}

std::string sheet_in_columns(const Sheet& sheet,
                             const std::vector<std::string>& without) {
  TextLines lines(sheet.rows.size() + 1);
  for (std::size_t i = 0; i < sheet.columns.size(); ++i) {
    const Column& column = sheet.columns[i];
    if (std::ranges::count(without, column.key) > 0) continue;
    lines[0].push_back(column.heading);
    for (std::size_t row = 0; row < sheet.rows.size(); ++row) {
      const Cell& cell = sheet.rows[row].cells[i];
      lines[row + 1].push_back(
          cell.number ? with_sign(column, rounded(column.format, *cell.number))
                      : cell.text);
    }
  }
  return in_columns(without_empty_columns(lines));
}

}  // namespace springcheck
