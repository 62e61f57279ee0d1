#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/cases/described.hpp"
#include "comparisons/running/case_result.hpp"
#include "comparisons/settings/run_settings.hpp"

namespace springcheck {

/// A quantity of a table: a measure in the table's unit.
struct Quantity {
  std::string name;    // "e"
  std::string unit;    // "%"
  std::string format;  // fmt's, for one double
  std::function<std::optional<double>(const Measures&)> of;
};

/// One row before it is computed.
struct PlannedRow {
  std::vector<std::string> labels;  // under the table's label headings
  Request request;
  std::optional<double> printed{};   // in the table's unit
  std::string printed_text{};        // with the printed digits, or empty
  std::string verdict;               // the thesis's on instabilities, or empty
  std::vector<std::string> notes{};  // footnotes, shared by equal text
};

/// A comparison table: what is computed, and what the thesis printed for it.
struct TablePlan {
  std::string name;  // "5.1"
  std::string title;
  std::vector<std::string> label_headings;
  Quantity quantity;
  std::vector<Quantity> further{};  // columns without a printed value
  std::vector<PlannedRow> rows{};
  std::vector<std::string> notes;  // on the table as a whole
};

/// Names of the tables beside the thesis's: 5.1, 5.2, 5.3, 5.4, deviation, bending.
const std::vector<std::string>& table_names();

/// The same, with what each shows.
std::vector<Described> described_thesis_tables();

/// The plan of a table of table_names(); `reference` replaces the default of requests().
TablePlan plan_table(const std::string& name,
                     const std::optional<ReferenceMethod>& reference);

/// A table's row with its result.
struct TableRow {
  PlannedRow plan;
  CaseResult result;
  std::optional<double> ours{};             // in the table's unit
  std::optional<double> difference{};       // ours - printed
  std::optional<double> reference_value{};  // the same quantity of the reference
  // Of an extrapolated one, the order observed and the error bar:
  std::optional<double> reference_order{}, reference_bar{};
  std::vector<std::optional<double>> further{};
};

struct Table {
  TablePlan plan;
  std::vector<TableRow> rows{};
};

/// The simulations a table needs: its rows and, for their values, the references.
std::vector<Request> table_requests(const TablePlan& plan);

/// Puts the results of table_requests, in that order, into the table.
Table fill_table(TablePlan plan, const std::vector<CaseResult>& results);

}  // namespace springcheck
