#pragma once

#include <concepts>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "comparisons/formats/table_format.hpp"
#include "comparisons/formats/text_table.hpp"

namespace springcheck {

/// A column of a table: of numbers where it has a format, else of texts.
struct Column {
  std::string key;         // its name in JSON
  std::string heading;     // in markdown and CSV, with the unit
  std::string format{};    // fmt's, for one double
  bool is_signed = false;  // numbers have a sign, of + too
  bool in_print = true;    // LaTeX, which is narrower than screens, has it too
};

/// A number of its column, or a text; both may be lacking. Beside a number the text is
/// ignored; where a number is lacking it says why. Either one makes a cell.
struct Cell {
  std::optional<double> number{};
  std::string text{};

  Cell() = default;
  Cell(double value) : number(value) {}
  Cell(std::integral auto count) : number(static_cast<double>(count)) {}
  Cell(std::optional<double> value, std::string otherwise = {})
      : number(value), text(std::move(otherwise)) {}
  Cell(std::convertible_to<std::string_view> auto const& words)
      : text(std::string_view(words)) {}
};

struct TableRow {
  std::vector<Cell> cells;           // one per column
  std::vector<std::string> notes{};  // footnotes, shared by equal text
  std::vector<std::string> cases{};  // keys of the simulations behind it, the main first
  std::string part{};                // what it is of, of several in one table; JSON alone
  // What JSON alone tells, or tells otherwise:
  nlohmann::ordered_json in_json = nlohmann::ordered_json::object();
};

/// A case of a table that did not end as it should.
struct BadCase {
  std::string name, status, reason;
};

struct Table {
  std::string name{}, title{};
  std::vector<Column> columns{};
  std::vector<TableRow> rows{};
  std::vector<std::string> notes{};  // on the table as a whole
  // What JSON alone tells:
  nlohmann::ordered_json in_json = nlohmann::ordered_json::object();
  std::string finding{};  // in a line, for a summary of tables
  std::vector<BadCase> bad_cases{};
};

/// Texts of a table: markdown rounds and shows the start of each row's first key; CSV and
/// JSON have all digits and all keys.
std::string format_table(const Table& table, TableFormat format);

/// The JSON schema of a table's JSON, which has a value for each column in each row.
nlohmann::ordered_json table_schema();

/// One after the other; as JSON one array.
std::string format_tables(const std::vector<Table>& tables, TableFormat format);

/// Rounded rows for a terminal, texts from the left, "-" for lacking numbers, without
/// columns that are empty throughout or named in `without`.
std::string table_in_columns(const Table& table, const Screen& screen = {},
                             const std::vector<std::string>& without = {});

}  // namespace springcheck
