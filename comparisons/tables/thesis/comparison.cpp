#include "comparisons/tables/thesis/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "comparisons/cases/grids.hpp"
#include "comparisons/studies/converged_number.hpp"
#include "comparisons/tables/thesis/table_notes.hpp"

namespace springcheck {
namespace {

/// Puts in the quantity of the reference, extrapolated where it ran on three grids. None
/// for deviations, which are from it.
void set_reference_value(ComparisonRow& row, const Quantity& quantity,
                         std::span<const CaseResult> runs) {
  if (runs.size() == 1) row.reference_value = value_of(quantity, runs.front().measures);
  if (runs.size() != 3) return;
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<double> value = value_of(quantity, runs[i].measures);
    if (!value) return;
    values[i] = *value;
  }
  const ConvergedNumber limit = converged_number(
      {runs[0].request.settings, runs[1].request.settings, runs[2].request.settings},
      values);
  row.reference_value = limit.value;
  row.reference_order = limit.order;
  row.reference_bar = limit.error_bound;
}

std::vector<Request> requests_of(const PlannedRow& row) {
  std::vector<Request> all{row.request};
  for (const CaseSettings& reference : reference_cases(row.request))
    all.push_back({.settings = reference});
  return all;
}

}  // namespace

std::optional<double> value_of(const Quantity& quantity, const Measures& measures) {
  const Measures::Value& value = measures.*quantity.measure;
  return value ? std::optional(quantity.factor * *value) : std::nullopt;
}

std::string heading(const Quantity& quantity) {
  return quantity.unit == "-" ? std::string(quantity.name)
                              : fmt::format("{} [{}]", quantity.name, quantity.unit);
}

Comparison compare(ComparisonPlan plan, std::span<const CaseResult> results) {
  Comparison comparison{.plan = std::move(plan)};
  for (const PlannedRow& planned : comparison.plan.rows) {
    const std::size_t references = reference_cases(planned.request).size();
    ComparisonRow row{.plan = planned, .result = results.front()};
    set_reference_value(row, comparison.plan.quantity, results.subspan(1, references));
    results = results.subspan(1 + references);
    row.ours = value_of(comparison.plan.quantity, row.result.measures);
    if (row.ours && planned.printed) row.difference = *row.ours - *planned.printed;
    for (const Quantity& quantity : comparison.plan.further)
      row.further.push_back(value_of(quantity, row.result.measures));
    if (std::ranges::count(row.result.flags, Status::wrinkled) > 0)
      row.plan.notes.emplace_back(table_notes::wrinkled);
    if (!row.result.revision.empty())
      row.plan.notes.push_back(
          fmt::format("Of revision {} of the numerics.", row.result.revision));
    comparison.rows.push_back(std::move(row));
  }
  return comparison;
}

TablePlan table_plan(const ComparisonPlan& plan) {
  TablePlan table{.make = [plan](std::span<const CaseResult> results,
                                 MeshStore&) { return table_of(compare(plan, results)); },
                  .needs_fields = false};
  for (const PlannedRow& row : plan.rows) {
    const std::vector<Request> requests = requests_of(row);
    table.requests.insert(table.requests.end(), requests.begin(), requests.end());
    table.row_sizes.push_back(requests.size());
  }
  table.of_rows = [plan](const std::vector<std::size_t>& rows) {
    ComparisonPlan part = plan;
    part.rows.clear();
    for (const std::size_t row : rows) part.rows.push_back(plan.rows.at(row));
    return table_plan(part);
  };
  return table;
}

}  // namespace springcheck
