#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/store/stored_columns.hpp"
#include "comparisons/store/hdf5.hpp"

namespace springcheck {

/// Puts a value into a row; what is lacking, or an empty text, is left out.
void put(Row& row, const std::string& name, const std::optional<std::string>& text);
void put(Row& row, const std::string& name, const std::optional<double>& number);

/// The text of an attribute. Throws std::runtime_error where `what` has no such
/// attribute, or an empty one.
std::string text_attribute(hid_t group, const char* name, const std::string& what);

/// Writes a new table into the group: row_of(part) of each part.
template <class Part, class RowOf>
void write_rows(hid_t group, const char* name, const std::vector<Part>& parts,
                const RowOf& row_of) {
  std::vector<Row> rows;
  for (const Part& part : parts) rows.push_back(row_of(part));
  append_rows(hdf5::create_group(group, name), rows);
}

/// What read(group) makes of each group in the one of that name; nothing without it.
template <class Read>
auto read_groups(hid_t root, const std::string& name, const Read& read) {
  std::vector<decltype(read(root))> all;
  if (!hdf5::has_link(root, name)) return all;
  const auto groups = hdf5::open_group(root, name);
  for (const std::string& link : hdf5::links(groups))
    all.push_back(read(hdf5::open_group(groups, link)));
  return all;
}

/// A table that is read row by row; columns that none of its rows has need not be there.
class TableRows {
 public:
  /// `what` is what it is a table of, for messages.
  TableRows(hid_t group, std::string what);

  [[nodiscard]] std::size_t count() const { return columns_.rows; }

  /// The value in a row; none where the row lacks it.
  [[nodiscard]] std::optional<std::string> find_text(const std::string& name,
                                                     std::size_t row) const;
  [[nodiscard]] std::optional<double> find_number(const std::string& name,
                                                  std::size_t row) const;

  /// The value in a row. They throw std::runtime_error where the row lacks it.
  [[nodiscard]] std::string text(const std::string& name, std::size_t row) const;
  [[nodiscard]] double number(const std::string& name, std::size_t row) const;

 private:
  Columns columns_;
  std::string what_;
};

}  // namespace springcheck
