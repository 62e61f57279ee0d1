#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "comparisons/sheets/table_format.hpp"

namespace springcheck {

/// A column of a sheet: of numbers where it has a format, else of texts.
struct Column {
  std::string key;         // its name in JSON
  std::string heading;     // in markdown and CSV, with the unit
  std::string format{};    // fmt's, for one double
  bool is_signed = false;  // numbers have a sign, of + too
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

struct SheetRow {
  std::vector<Cell> cells;           // one per column
  std::vector<std::string> notes{};  // footnotes, shared by equal text
  std::vector<std::string> cases{};  // keys of the simulations behind it, the main first
  std::string part{};                // what it is of, of several in one sheet; JSON alone
};

/// A table of our own figures, of which the thesis printed none.
struct Sheet {
  std::string name;
  std::string title;
  std::vector<Column> columns{};
  std::vector<SheetRow> rows{};
  std::vector<std::string> notes{};  // on the sheet as a whole
};

/// Texts of a sheet: markdown rounds and shows the start of each row's first key; CSV and
/// JSON have all digits and all keys.
std::string format_sheet(const Sheet& sheet, TableFormat format);

/// One after the other; as JSON one array.
std::string format_sheets(const std::vector<Sheet>& sheets, TableFormat format);

/// Rounded rows for a terminal, without columns that are empty throughout or named in
/// `without`.
std::string sheet_in_columns(const Sheet& sheet,
                             const std::vector<std::string>& without = {});

}  // namespace springcheck
