#include "comparisons/imported/nodal_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>

#include "comparisons/imported/nodal_vectors.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

constexpr std::string_view csv_blanks = " \t\r";

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(csv_blanks),
             last = text.find_last_not_of(csv_blanks);
  return first == std::string_view::npos
             ? ""
             : std::string(text.substr(first, last - first + 1));
}

/// What stands between the fields of a line: the first of these that there is, or
/// csv_blanks.
char separator_of(const std::string& line) {
  for (const char separator : {';', ',', '\t'})
    if (line.find(separator) != std::string::npos) return separator;
  return ' ';
}

/// The fields of a line without their quotes, within which a separator is a character.
std::vector<std::string> fields_of(const std::string& line, char separator) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"')
      is_quoted = !is_quoted;
    else if (c == separator && !is_quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  for (std::string& field : fields) field = trimmed(field);
  if (separator == ' ') std::erase(fields, "");  // several blanks part as one does
  return fields;
}

/// A column's name in small letters, without what says nothing new: "ux" for "UX [m]".
std::string plain_name(const std::string& field, std::string_view unit) {
  std::string name;
  for (const char c : field)
    name +=
        c == '_' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const std::string& bracketed :
       {fmt::format("[{}]", unit), fmt::format("({})", unit)})
    if (name.ends_with(bracketed)) name.resize(name.size() - bracketed.size());
  return trimmed(name);
}

/// The columns that a row is read from.
struct CsvColumns {
  char separator = ',';
  std::vector<std::string> names{};
  std::vector<std::size_t> place{};  // of x, y, z or of node
  std::vector<std::size_t> value{};  // of the three components

  [[nodiscard]] bool are_known() const { return !place.empty() && !value.empty(); }
};

/// The places of the wanted columns, each under one of its names, once; empty where one
/// is lacking or there twice.
std::vector<std::size_t> places_of(const std::vector<std::string>& names,
                                   const std::vector<std::vector<std::string>>& wanted) {
  std::vector<std::size_t> places;
  for (const std::vector<std::string>& aliases : wanted) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (std::ranges::count(aliases, names[i]) > 0) found.push_back(i);
    if (found.size() != 1) return {};
    places.push_back(found.front());
  }
  return places;
}

/// The columns of a header: "x,y,z,ux,uy,uz" or "node,ux,uy,uz", in any order, among
/// others. Numbers of nodes are often those of another program: coordinates come first.
CsvColumns columns_of(const std::string& header, NodalQuantity quantity) {
  const bool is_displacement = quantity == NodalQuantity::displacement;
  CsvColumns columns{.separator = separator_of(header)};
  for (const std::string& field : fields_of(header, columns.separator)) {
    columns.names.push_back(plain_name(field, is_displacement ? "m" : "n"));
    if (!is_displacement) columns.names.back() = plain_name(columns.names.back(), "m");
  }
  const std::string letter = is_displacement ? "u" : "f";
  columns.place = places_of(columns.names, {{"x"}, {"y"}, {"z"}});
  if (columns.place.empty())
    columns.place = places_of(columns.names, {{"node", "id", "node id", "node number"}});
  columns.value =
      places_of(columns.names, {{letter + "x"}, {letter + "y"}, {letter + "z"}});
  return columns;
}

/// A row of numbers under their columns.
class CsvRow {
 public:
  CsvRow(const CsvColumns& columns, std::string where, const std::string& line)
      : columns_(columns),
        where_(std::move(where)),
        fields_(fields_of(line, columns.separator)) {
    if (fields_.size() != columns.names.size())
      throw InputError(where_, "", fmt::format("{} values", columns.names.size()),
                       fmt::format("{}: '{}'", fields_.size(), line));
    if (columns.separator != ',')  // a comma is then that of decimals
      for (std::string& field : fields_) std::ranges::replace(field, ',', '.');
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
    if (line.ends_with('\r')) line.pop_back();
    if (trimmed(line).empty()) continue;
    const bool is_comment = line.starts_with('#') || line.starts_with('%');
    if (rows == 0) {  // a comment may tell the names, and a line behind it again
      const std::string header = line.substr(is_comment ? 1 : 0);
      const CsvColumns found = columns_of(header, quantity);
      if (found.are_known()) columns = found;
      if (found.are_known() || is_comment) continue;
    }
    if (!columns.are_known()) {
      const char* components = is_displacement ? "ux,uy,uz" : "fx,fy,fz";
      throw InputError(where, "columns",
                       fmt::format("x,y,z,{0} or node,{0}, each once", components),
                       "'" + trimmed(line) + "'");
    }
    if (is_comment) continue;
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
                     columns.are_known() ? "no row" : "none");
  return is_displacement ? vectors.complete(name) : vectors.or_zero();
}

}  // namespace springcheck
