#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

TablePlan without_cases(Table (*make)()) {
  return {.make = [make](std::span<const CaseResult>, MeshStore&) { return make(); }};
}

Cell value_or_status(const std::optional<double>& value, const CaseResult& result) {
  return {value, std::string(name_of(result.status))};
}

}  // namespace springcheck
