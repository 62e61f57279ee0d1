#include "comparisons/measured/nodal_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>

#include "comparisons/measured/nodal_vectors.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r"),
             last = text.find_last_not_of(" \t\r");
  return first == std::string_view::npos
             ? ""
             : std::string(text.substr(first, last - first + 1));
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t comma = std::min(line.find(',', begin), line.size());
    fields.push_back(trimmed(std::string_view(line).substr(begin, comma - begin)));
    begin = comma + 1;
  }
  return fields;
}

/// Where the columns stand that a row is read from.
struct CsvColumns {
  std::vector<std::string> names;
  std::vector<std::size_t> place{};  // of x, y, z or of node
  std::vector<std::size_t> value{};  // of the three components
};

/// "x,y,z,ux,uy,uz" or "node,ux,uy,uz", in any order.
CsvColumns columns_of(const std::string& where, const std::string& header,
                      NodalQuantity quantity) {
  const std::vector<std::string> by_point{"x", "y", "z"}, by_number{"node"},
      displacement{"ux", "uy", "uz"}, force{"fx", "fy", "fz"};
  const auto& components = quantity == NodalQuantity::displacement ? displacement : force;
  CsvColumns columns{.names = fields_of(header)};
  const auto find_all = [&](const std::vector<std::string>& wanted) {
    std::vector<std::size_t> places;
    for (const std::string& name : wanted) {
      const auto found = std::ranges::find(columns.names, name);
      if (found == columns.names.end()) return std::vector<std::size_t>{};
      places.push_back(static_cast<std::size_t>(found - columns.names.begin()));
    }
    return places;
  };
  columns.place = find_all(by_point);
  if (columns.place.empty()) columns.place = find_all(by_number);
  columns.value = find_all(components);
  // As many as are read: nothing unknown, nothing twice, no node beside x, y, z.
  if (columns.place.empty() || columns.value.empty() ||
      columns.names.size() != columns.place.size() + columns.value.size())
    throw InputError(where, "columns",
                     fmt::format("x,y,z,{0} or node,{0}", fmt::join(components, ",")),
                     "'" + header + "'");
  return columns;
}

/// A row of numbers under their columns.
class CsvRow {
 public:
  CsvRow(const CsvColumns& columns, std::string where, const std::string& line)
      : columns_(columns), where_(std::move(where)), fields_(fields_of(line)) {
    if (fields_.size() != columns.names.size())
      throw InputError(where_, "", fmt::format("{} numbers", columns.names.size()),
                       fmt::format("{}: '{}'", fields_.size(), line));
  }

  [[nodiscard]] Vector3 vector(const std::vector<std::size_t>& columns) const {
    return {number(columns[0]), number(columns[1]), number(columns[2])};
  }

  /// The node of this number, counted from 1.
  [[nodiscard]] NodeIndex node(std::size_t column, std::size_t nodes) const {
    const double number_from_1 = number(column);
    if (!(number_from_1 >= 1 && number_from_1 <= static_cast<double>(nodes)) ||
        number_from_1 != std::floor(number_from_1))
      throw InputError(where_, "node",
                       fmt::format("a number from 1 to {}, the mesh's nodes", nodes),
                       "'" + fields_[column] + "'");
    return static_cast<NodeIndex>(number_from_1) - 1;
  }

 private:
  [[nodiscard]] double number(std::size_t column) const {
    const std::string& field = fields_[column];
    const char* const end = field.data() + field.size();
    const char* const begin = field.data() + (field.starts_with('+') ? 1 : 0);
    double value = 0;
    const auto [rest, error] = std::from_chars(begin, end, value);
    if (error != std::errc{} || rest != end)
      throw InputError(where_, columns_.names[column], "a number", "'" + field + "'");
    return value;
  }

  const CsvColumns& columns_;
  std::string where_;
  std::vector<std::string> fields_;
};

}  // namespace

std::vector<Vector3> read_nodal_csv(const std::filesystem::path& file, const Mesh& mesh,
                                    NodalQuantity quantity) {
  const std::string name = file.string();
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    throw InputError(name, "", "a readable CSV file",
                     in ? "a directory" : std::strerror(errno));
  const bool is_displacement = quantity == NodalQuantity::displacement;
  NodalVectors vectors(mesh, is_displacement ? "displacement" : "force");
  CsvColumns columns;
  std::size_t line_number = 0, rows = 0;
  for (std::string line; std::getline(in, line);) {
    const std::string where = fmt::format("{}:{}", name, ++line_number);
    if (line_number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
    line = trimmed(line);
    if (line.empty()) continue;
    if (columns.names.empty()) {
      columns = columns_of(where, trimmed(line.substr(line.starts_with('#') ? 1 : 0)),
                           quantity);
      continue;
    }
    ++rows;
    const CsvRow row(columns, where, line);
    const Vector3 value = row.vector(columns.value);
    if (columns.place.size() == 1)
      vectors.add(where, row.node(columns.place.front(), mesh.nodes().size()), value);
    else
      vectors.add_at(where, row.vector(columns.place), 0, value);
  }
  if (in.bad()) throw InputError(name, "", "a readable CSV file", std::strerror(errno));
  if (rows == 0)
    throw InputError(name, "", "a line of column names and at least one row",
                     columns.names.empty() ? "an empty file" : "no row");
  return is_displacement ? vectors.complete(name) : vectors.or_zero();
}

}  // namespace springcheck
