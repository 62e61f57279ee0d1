#pragma once

#include <string>
#include <vector>

#include "comparisons/cases/described.hpp"
#include "comparisons/tables/plans/sheet_plan.hpp"

namespace springcheck {

/// Tables of our own, beside those of table_names().
const std::vector<std::string>& sheet_names();

/// Those that take many minutes; `reproduce` leaves them out unless asked for all.
const std::vector<std::string>& long_sheet_names();

/// Those computed when they are printed, with no case behind them: result files cannot
/// give them back.
const std::vector<std::string>& caseless_sheet_names();

/// Every table that `springcheck table` prints, and what it shows.
std::vector<Described> described_tables();

/// Of sheet_names().
SheetPlan plan_sheet(const std::string& name);

/// Throws InputError for a name that is neither of table_names() nor of sheet_names().
void check_table_name(const std::string& name);

}  // namespace springcheck
