#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "comparisons/formats/table.hpp"
#include "comparisons/running/case_result.hpp"

namespace springcheck {

/// A table before it is computed: the simulations it needs, and how its columns, rows and
/// notes are made of their results, which come in the same order; of those that ended
/// well with their fields, where it needs them.
struct TablePlan {
  std::vector<Request> requests{};
  std::function<Table(std::span<const CaseResult>, MeshStore&)> make;
  bool needs_fields = true;

  // For a table whose rows stand by themselves: how many of the requests belong to each
  // row, its case and then its references; and the plan of some of its rows. Other tables
  // are made of all results or not at all.
  std::vector<std::size_t> row_sizes{};
  std::function<TablePlan(const std::vector<std::size_t>& rows)> of_rows{};
};

/// A table that needs no simulation of its own.
TablePlan without_cases(Table (*make)());

/// A value for a cell, or the status that stands in its place.
Cell value_or_status(const std::optional<double>& value, const CaseResult& result);

}  // namespace springcheck
