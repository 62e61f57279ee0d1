#include "comparisons/tables/plans/sheet_plan.hpp"

namespace springcheck {

SheetPlan without_cases(Sheet (*make)()) {
  return {.make = [make](std::span<const CaseResult>, MeshStore&) { return make(); }};
}

Cell value_or_status(const std::optional<double>& value, const CaseResult& result) {
  return {value, std::string(name_of(result.status))};
}

}  // namespace springcheck
