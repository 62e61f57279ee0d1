#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace springcheck {

/// Numbers of a table, one or several in a row; what a row lacks is NaN.
struct NumberColumn {
  std::size_t width;
  std::vector<double> values;  // row by row
};

/// A table whose columns, all of one length, are texts, empty where a row has none, or
/// numbers.
struct Columns {
  std::size_t rows = 0;
  std::map<std::string, std::vector<std::string>> texts;
  std::map<std::string, NumberColumn> numbers;
};

/// The names of a row's numbers, those of a vector or a matrix by rows: x, y, z or xx,
/// xy, ... zz; empty for another width.
std::span<const std::string_view> component_names(std::size_t width);

/// The values of one row by column.
using Row = std::map<std::string, std::variant<std::string, std::vector<double>>>;

/// A row of a table that was read, without what it lacks.
Row row_at(const Columns& table, std::size_t index);

/// The given rows of the table, in their order.
Columns selected(const Columns& table, std::span<const std::size_t> rows);

}  // namespace springcheck
