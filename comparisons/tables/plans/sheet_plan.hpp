#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "comparisons/running/case_result.hpp"
#include "comparisons/sheets/sheet.hpp"

namespace springcheck {

/// A sheet before it is computed: the simulations it needs, and how it is made of their
/// results, which come in the same order and with their fields.
struct SheetPlan {
  std::vector<Request> requests{};
  std::function<Sheet(std::span<const CaseResult>, MeshStore&)> make;
};

/// A sheet that needs no simulation of its own.
SheetPlan without_cases(Sheet (*make)());

/// A value for a cell, or the status that stands in its place.
Cell value_or_status(const std::optional<double>& value, const CaseResult& result);

}  // namespace springcheck
