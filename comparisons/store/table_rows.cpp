#include "comparisons/store/table_rows.hpp"

#include <cmath>
#include <stdexcept>

namespace springcheck {
namespace {

template <class Value>
Value required(std::optional<Value> found, const std::string& what,
               const std::string& name) {
  if (!found) throw std::runtime_error(what + " lacks a " + name);
  return *std::move(found);
}

}  // namespace

void put(Row& row, const std::string& name, const std::optional<std::string>& text) {
  if (text && !text->empty()) row[name] = *text;
}

void put(Row& row, const std::string& name, const std::optional<double>& number) {
  if (number) row[name] = std::vector{*number};
}

std::string text_attribute(hid_t group, const char* name, const std::string& what) {
  std::optional<std::string> text = hdf5::read_text(group, name);
  if (text && text->empty()) text.reset();
  return required(std::move(text), what, name);
}

TableRows::TableRows(hid_t group, std::string what)
    : columns_(read_columns(group)), what_(std::move(what)) {}

std::optional<std::string> TableRows::find_text(const std::string& name,
                                                std::size_t row) const {
  const auto column = columns_.texts.find(name);
  if (column == columns_.texts.end() || column->second[row].empty()) return {};
  return column->second[row];
}

std::optional<double> TableRows::find_number(const std::string& name,
                                             std::size_t row) const {
  const auto column = columns_.numbers.find(name);
  if (column == columns_.numbers.end() || column->second.width != 1) return {};
  const double value = column->second.values[row];
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

std::string TableRows::text(const std::string& name, std::size_t row) const {
  return required(find_text(name, row), what_, name);
}

double TableRows::number(const std::string& name, std::size_t row) const {
  return required(find_number(name, row), what_, name);
}

}  // namespace springcheck
