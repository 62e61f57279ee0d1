#include "comparisons/store/columns.hpp"

#include <algorithm>
#include <cmath>

namespace springcheck {

std::span<const std::string_view> component_names(std::size_t width) {
  static constexpr std::string_view vector[] = {"x", "y", "z"};
  static constexpr std::string_view matrix[] = {"xx", "xy", "xz", "yx", "yy",
                                                "yz", "zx", "zy", "zz"};
  if (width == std::size(vector)) return vector;
  if (width == std::size(matrix)) return matrix;
  return {};
}

Row row_at(const Columns& table, std::size_t index) {
  Row row;
  for (const auto& [name, texts] : table.texts)
    if (!texts[index].empty()) row[name] = texts[index];
  for (const auto& [name, column] : table.numbers) {
    const auto first =
        column.values.begin() + static_cast<std::ptrdiff_t>(index * column.width);
    std::vector<double> values(first, first + static_cast<std::ptrdiff_t>(column.width));
    if (!std::ranges::all_of(values, [](double x) { return std::isnan(x); }))
      row[name] = std::move(values);
  }
  return row;
}

Columns selected(const Columns& table, std::span<const std::size_t> rows) {
  Columns part;
  part.rows = rows.size();
  for (const auto& [name, texts] : table.texts)
    for (auto& column = part.texts[name]; const std::size_t row : rows)
      column.push_back(texts[row]);
  for (const auto& [name, column] : table.numbers) {
    NumberColumn& own = part.numbers[name];
    own.width = column.width;
    for (const std::size_t row : rows) {
      const auto first =
          column.values.begin() + static_cast<std::ptrdiff_t>(row * column.width);
      own.values.insert(own.values.end(), first,
                        first + static_cast<std::ptrdiff_t>(column.width));
    }
  }
  return part;
}

}  // namespace springcheck
