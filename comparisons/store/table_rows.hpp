#pragma once

#include <optional>
#include <string>

#include "comparisons/store/columns.hpp"

namespace springcheck {

/// Puts a value into a row; what is lacking, or an empty text, is left out.
void put(Row& row, const char* name, const std::optional<std::string>& text);
void put(Row& row, const char* name, const std::optional<double>& number);

/// A table that is read row by row; columns that none of its rows has need not be there.
class TableRows {
 public:
  /// what: it is a table of, for messages.
  TableRows(hid_t group, std::string what);

  [[nodiscard]] std::size_t count() const { return columns_.rows; }

  /// None where the row lacks it.
  [[nodiscard]] std::optional<std::string> find_text(const char* name,
                                                     std::size_t row) const;
  [[nodiscard]] std::optional<double> find_number(const char* name,
                                                  std::size_t row) const;

  /// Throw std::runtime_error where the row lacks it.
  [[nodiscard]] std::string text(const char* name, std::size_t row) const;
  [[nodiscard]] double number(const char* name, std::size_t row) const;

 private:
  Columns columns_;
  std::string what_;
};

}  // namespace springcheck
