#include "comparisons/formats/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/formats/latex_table.hpp"
#include "comparisons/formats/text_table.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> footnotes(const Table& table) {
  std::vector<std::string> notes;
  for (const TableRow& row : table.rows)
    for (const std::string& note : row.notes)
      if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
  return notes;
}

/// The digits of a number of the column, with its plus where the column has signs.
std::string with_sign(const Column& column, const std::string& digits) {
  return column.is_signed && digits.front() != '-' ? "+" + digits : digits;
}

/// Head line and rows; shown(column, cell) is a cell's text.
template <class Shown, class Notes, class Cases>
TextLines lines_of(const Table& table, Shown&& shown, Notes&& notes, Cases&& cases) {
  TextLines lines(1);
  for (const Column& column : table.columns) lines[0].push_back(column.heading);
  lines[0].insert(lines[0].end(), {"notes", "case"});
  for (const TableRow& row : table.rows) {
    std::vector<std::string> line;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const Cell& cell = row.cells.at(i);
      line.push_back(
          cell.number ? with_sign(table.columns[i], shown(table.columns[i], *cell.number))
                      : cell.text);
    }
    line.insert(line.end(), {notes(row), cases(row)});
    lines.push_back(std::move(line));
  }
  return lines;
}

/// Heads and rounded rows, without the columns that are empty in every row.
TextLines grid(const Table& table, const std::vector<std::string>& notes) {
  const auto marks = [&](const TableRow& row) {
    std::vector<std::ptrdiff_t> numbers;
    for (const std::string& note : row.notes)
      numbers.push_back(std::ranges::find(notes, note) - notes.begin() + 1);
    return fmt::format("{}", fmt::join(numbers, " "));
  };
  const auto key = [](const TableRow& row) {
    return row.cases.empty() ? std::string() : row.cases.front().substr(0, 12);
  };
  return without_empty_columns(lines_of(
      table,
      [](const Column& column, double number) { return rounded(column.format, number); },
      marks, key));
}

/// The table without the columns that print has no room for.
Table in_print(const Table& table) {
  Table narrow = table;
  std::erase_if(narrow.columns, [](const Column& column) { return !column.in_print; });
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    std::vector<Cell>& cells = narrow.rows[row].cells;
    cells.clear();
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      if (table.columns[i].in_print) cells.push_back(table.rows[row].cells.at(i));
  }
  return narrow;
}

std::string csv(const Table& table) {
  return csv_text(lines_of(
      table, [](const Column&, double number) { return fmt::format("{}", number); },
      [](const TableRow& row) { return fmt::format("{}", fmt::join(row.notes, " ")); },
      [](const TableRow& row) { return fmt::format("{}", fmt::join(row.cases, " ")); }));
}

Json json(const Column& column, const Cell& cell) {
  if (!column.format.empty()) return cell.number ? Json(*cell.number) : Json();
  return cell.text.empty() ? Json() : Json(cell.text);
}

std::string json_text(const Table& table) {
  Json rows = Json::array();
  for (const TableRow& row : table.rows) {
    Json out;
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      out[table.columns[i].key] = json(table.columns[i], row.cells[i]);
    out["notes"] = row.notes;
    out["case"] = row.cases.empty() ? Json() : Json(row.cases.front());
    out["cases"] = row.cases;
    if (!row.part.empty()) out["part"] = row.part;
    out.update(row.in_json);
    rows.push_back(out);
  }
  Json columns = Json::array();
  for (const Column& column : table.columns)
    columns.push_back({{"key", column.key},
                       {"heading", column.heading},
                       {"format", column.format.empty() ? Json() : Json(column.format)}});
  Json document{{"springcheck", build_info::version},
                {"table", table.name},
                {"title", table.title}};
  document.update(table.in_json);
  document.update(Json{{"columns", columns}, {"rows", rows}, {"notes", table.notes}});
  return document.dump(2) + "\n";
}

}  // namespace

std::string format_table(const Table& table, TableFormat format) {
  const std::vector<std::string> notes = footnotes(table);
  const TableText text{.title = table.title, .notes = table.notes, .footnotes = notes};
  switch (format) {
    case TableFormat::markdown:
      return markdown_text(grid(table, notes), text);
    case TableFormat::latex:
      return latex_text(grid(in_print(table), notes), text);
    case TableFormat::csv:
      return csv(table);
    case TableFormat::json:
      return json_text(table);
  }
  return {};
}

Json table_schema() {
  const Json text{{"type", "string"}}, texts{{"type", "array"}, {"items", text}},
      text_or_null{{"type", {"string", "null"}}};
  const auto object = [](const Json& properties) {
    Json names = Json::array();
    for (auto one = properties.begin(); one != properties.end(); ++one)
      names.push_back(one.key());
    return Json{{"type", "object"}, {"properties", properties}, {"required", names}};
  };
  const auto list_of = [](const Json& items) {
    return Json{{"type", "array"}, {"items", items}};
  };
  const Json column =
      object({{"key", text}, {"heading", text}, {"format", text_or_null}});
  const Json row = object({{"notes", texts}, {"case", text_or_null}, {"cases", texts}});
  return object({{"springcheck", text},
                 {"table", text},
                 {"title", text},
                 {"columns", list_of(column)},
                 {"rows", list_of(row)},
                 {"notes", texts}});
}

std::string format_tables(const std::vector<Table>& tables, TableFormat format) {
  const bool is_json = format == TableFormat::json;
  std::string text = is_json ? "[\n" : "";
  for (std::size_t i = 0; i < tables.size(); ++i)
    text += (i == 0 ? "" : is_json ? ",\n" : "\n") + format_table(tables[i], format);
  return text + (is_json ? "]\n" : "");
}

std::string table_in_columns(const Table& table, const Screen& screen,
                             const std::vector<std::string>& without) {
  TextLines lines(table.rows.size() + 1);
  std::vector<Align> alignment;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Column& column = table.columns[i];
    std::vector<std::string> cells;
    for (const TableRow& row : table.rows) {
      const Cell& cell = row.cells[i];
      cells.push_back(cell.number
                          ? with_sign(column, rounded(column.format, *cell.number))
                          : cell.text);
    }
    if (std::ranges::count(without, column.key) > 0 ||
        std::ranges::all_of(cells, &std::string::empty))
      continue;
    if (!column.format.empty()) std::ranges::replace(cells, "", "-");
    alignment.push_back(column.format.empty() ? Align::left : Align::right);
    lines[0].push_back(column.heading);
    for (std::size_t row = 0; row < cells.size(); ++row)
      lines[row + 1].push_back(std::move(cells[row]));
  }
  return in_columns(lines, alignment, screen);
}

}  // namespace springcheck
