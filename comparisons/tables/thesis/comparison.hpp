#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/tables/plans/table_plan.hpp"

namespace springcheck {

/// What is compared: a measure in a table's unit.
struct Quantity {
  std::string_view name;    // "e"
  std::string_view unit;    // "%"; "-" of what has none
  std::string_view format;  // fmt's, for one double
  Measures::Value Measures::*measure;
  double factor;  // from SI to the unit
};

/// In its unit.
std::optional<double> value_of(const Quantity& quantity, const Measures& measures);

/// "e [%]".
std::string heading(const Quantity& quantity);

/// One row before it is computed.
struct PlannedRow {
  std::vector<std::string> labels;  // under the comparison's label headings
  Request request;
  std::optional<double> printed{};   // in the unit of the quantity
  std::string printed_text{};        // with the printed digits, or empty
  std::string verdict;               // the thesis's on instabilities, or empty
  std::vector<std::string> notes{};  // footnotes, shared by equal text
};

/// Cases of ours beside what the thesis printed of them.
struct ComparisonPlan {
  std::vector<std::string> label_headings;
  Quantity quantity;
  std::vector<Quantity> further{};  // without printed values
  std::vector<PlannedRow> rows{};
  std::vector<std::string> notes;
};

/// A row with its result.
struct ComparisonRow {
  PlannedRow plan;
  CaseResult result;
  std::optional<double> ours{};             // in the unit of the quantity
  std::optional<double> difference{};       // ours - printed
  std::optional<double> reference_value{};  // the same quantity of the reference
  // The observed order and the error bound of an extrapolated reference:
  std::optional<double> reference_order{}, reference_bar{};
  std::vector<std::optional<double>> further{};
};

struct Comparison {
  ComparisonPlan plan;
  std::vector<ComparisonRow> rows{};
};

/// The comparison of a plan with the results of each row's request and of its references,
/// in this order.
Comparison compare(ComparisonPlan plan, std::span<const CaseResult> results);

/// Every row names its reference, its status and the key of its case; a row without a
/// value shows its status in the value's place. The finding is how far mss-cf, and the
/// law nearest to the thesis's finite elements, are from print.
Table table_of(const Comparison& comparison);

/// The plan of a comparison: its simulations, its rows each for itself, and table_of what
/// is made of them.
TablePlan table_plan(const ComparisonPlan& plan);

}  // namespace springcheck
