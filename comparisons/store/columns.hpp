#pragma once

#include <hdf5.h>

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace springcheck {

/// A table as an HDF5 group holds it: a dataset for each column, all of one length, so
/// that h5py and HDFView show it as it is. Columns are texts (UTF-8, padded with zeros)
/// or numbers, one or several in a row (of shape rows x width). What a row lacks is an
/// empty text or NaN.
struct NumberColumn {
  std::size_t width;
  std::vector<double> values;  // row by row
};

struct Columns {
  std::size_t rows = 0;
  std::map<std::string, std::vector<std::string>> texts;
  std::map<std::string, NumberColumn> numbers;
};

/// Of a row's numbers, of a vector or a matrix by rows: x, y, z or xx, xy, ... zz; empty
/// of another width.
std::span<const std::string_view> component_names(std::size_t width);

/// One row's values by column.
using Row = std::map<std::string, std::variant<std::string, std::vector<double>>>;

/// A row of a table that was read, without what it lacks.
Row row_at(const Columns& table, std::size_t index);

/// Rows of the table in the group: the length of its columns.
std::size_t row_count(hid_t group);

/// Appends rows, making the columns that are new. The cost does not depend on the rows
/// there are, unless a text is longer than all before in its column, which is then
/// rewritten. Throws std::runtime_error when a value does not fit its column's kind or
/// width.
void append_rows(hid_t group, std::span<const Row> rows);

/// Replaces a row. Columns it lacks become NaN or empty.
void replace_row(hid_t group, std::size_t index, const Row& row);

/// All columns, or one of texts or numbers, empty where there is none. Throws
/// std::runtime_error when their lengths differ.
Columns read_columns(hid_t group);
std::vector<std::string> read_texts(hid_t group, const std::string& column);
std::vector<double> read_number_column(hid_t group, const std::string& column);

/// Those rows of the table, in their order.
Columns selected(const Columns& table, std::span<const std::size_t> rows);

}  // namespace springcheck
