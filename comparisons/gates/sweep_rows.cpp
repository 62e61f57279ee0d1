#include "comparisons/gates/sweep_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "comparisons/studies/extrapolation.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck::gates {
namespace {

std::span<const double> numbers(const Columns& cases, const std::string& column,
                                std::size_t row) {
  const NumberColumn& found = cases.numbers.at(column);
  return std::span(found.values).subspan(row * found.width, found.width);
}

/// A number, or the product of several.
double position(const Columns& cases, const std::string& column, std::size_t row) {
  double product = 1;
  for (const double number : numbers(cases, column, row)) product *= number;
  return product;
}

/// One case for each value that the condition lists.
std::vector<std::size_t> listed_rows(const Columns& cases, const Selection& where,
                                     const Condition& along, const MeasureColumn& asked) {
  std::vector<std::size_t> rows;
  for (const auto& value : values_of(along, cases.numbers.at(along.column).width)) {
    Condition one = along;
    one.values = {value};
    one.is_flat_list = false;
    rows.push_back(one_row(cases, narrowed(where, {one}), {&asked, 1}));
  }
  return rows;
}

void check_sweep(const Columns& cases, const std::string& along,
                 const std::vector<std::size_t>& rows) {
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (same_number(position(cases, along, rows[i - 1]), position(cases, along, rows[i])))
      throw NoCase(fmt::format("several cases with {} = {}; they differ in {}", along,
                               cell_text(cases, along, rows[i]),
                               differences_text(cases, {rows[i - 1], rows[i]})));
  std::set<std::string> others = differences(cases, rows);
  // The default reference follows from the deformation; a gate that minds names it.
  for (const std::string& allowed : {along, std::string("reference"), std::string("key")})
    others.erase(allowed);
  if (!others.empty())
    throw NoCase(fmt::format("the cases along {} differ in {} too", along,
                             fmt::join(others, ", ")));
}

/// Whether a gate that asks these measures gets the same of both cases.
bool agree(const Columns& cases, std::size_t a, std::size_t b,
           std::span<const MeasureColumn> asked) {
  return cell_text(cases, "status", a) == cell_text(cases, "status", b) &&
         std::ranges::all_of(asked, [&](const MeasureColumn& measure) {
           const auto of_a = value_of(measure, cases, a),
                      of_b = value_of(measure, cases, b);
           return of_a && of_b ? same_number(*of_a, *of_b) : !of_a && !of_b;
         });
}

}  // namespace

std::size_t one_row(const Columns& cases, const Selection& selection,
                    std::span<const MeasureColumn> asked) {
  const std::vector<std::size_t> rows = matching(cases, selection);
  const bool is_one = !rows.empty() && std::ranges::all_of(rows, [&](std::size_t row) {
    return agree(cases, rows.front(), row, asked);
  });
  if (is_one) return rows.front();
  std::string text = why_not_one(cases, selection, rows);
  std::vector<std::string> columns{"status"};
  for (const MeasureColumn& measure : asked) columns.push_back(measure.column);
  for (const std::string& column : columns) {
    std::set<std::string> values;
    for (const std::size_t row : rows) values.insert(cell_text(cases, column, row));
    if (values.size() > 1)
      text += fmt::format("; their {} is {}", column, fmt::join(values, " or "));
  }
  throw NoCase(text);
}

std::vector<std::size_t> sweep_rows(const Columns& cases, const Gate& gate,
                                    const std::string& along, std::size_t least,
                                    const MeasureColumn& asked) {
  std::vector<std::size_t> rows = matching(cases, gate.where);
  if (rows.empty()) throw NoCase(why_not_one(cases, gate.where, rows));
  if (!cases.numbers.contains(along))
    throw InputError(gate.place, "along", "a setting that is a number",
                     "'" + along + "'");
  const auto listed = std::ranges::find(gate.where, along, &Condition::column);
  if (listed != gate.where.end()) rows = listed_rows(cases, gate.where, *listed, asked);
  for (const std::size_t row : rows)
    if (std::isnan(position(cases, along, row)))
      throw NoCase(fmt::format("case {} has no {}", cell_text(cases, "key", row), along));
  std::ranges::stable_sort(rows, {},
                           [&](std::size_t row) { return position(cases, along, row); });
  const auto again = std::ranges::unique(rows, [&](std::size_t a, std::size_t b) {
    return same_number(position(cases, along, a), position(cases, along, b)) &&
           agree(cases, a, b, {&asked, 1});
  });
  rows.erase(again.begin(), again.end());
  if (rows.size() < least)
    throw NoCase(fmt::format("{} of at least {} cases along {} match {}", rows.size(),
                             least, along, text_of(gate.where)));
  check_sweep(cases, along, rows);
  return rows;
}

std::vector<std::size_t> finest_grids(const Columns& cases, const Gate& gate,
                                      const MeasureColumn& asked) {
  std::vector<std::size_t> rows = sweep_rows(cases, gate, "cells", 3, asked);
  rows.erase(rows.begin(), rows.end() - 3);
  const auto finest = numbers(cases, "cells", rows.back());
  for (const std::size_t row : rows) {
    const auto counts = numbers(cases, "cells", row);
    for (std::size_t axis = 1; axis < counts.size(); ++axis)
      if (!same_number(counts[axis] * finest[0], finest[axis] * counts[0]))
        throw NoCase(fmt::format("cells {} and {} are not refined alike along all axes",
                                 cell_text(cases, "cells", row),
                                 cell_text(cases, "cells", rows.back())));
  }
  return rows;
}

std::optional<double> order_on(const Columns& cases, const std::vector<std::size_t>& rows,
                               const std::vector<double>& values) {
  GridSizes sizes{};
  for (std::size_t i = 0; i < sizes.size(); ++i)
    sizes[i] = 1 / numbers(cases, "cells", rows[i])[0];
  return observed_order(sizes, values[0] - values[1], values[1] - values[2]);
}

}  // namespace springcheck::gates
